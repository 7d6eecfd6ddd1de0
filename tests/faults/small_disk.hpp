// A file system of its own for a server's state, which can be full: a tmpfs in this process's own mount namespace.
#pragma once

#include <filesystem>

namespace foothold::faults {

class SmallDisk {
 public:
  // Mounts it at `folder`, which is made. Where this is not allowed, available() is false and the folder an ordinary one.
  explicit SmallDisk(std::filesystem::path folder);
  ~SmallDisk();
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool available() const { return mounted_; }
  // Leaves no room; takes no memory for it. False if that did not succeed.
  bool fill();
  bool empty();  // room again

 private:
  std::filesystem::path folder_;
  bool mounted_ = false;
};

}  // namespace foothold::faults
