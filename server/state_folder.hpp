// The server's folder on disk: made if it is not there, and held by one server at a time.
#pragma once

#include <stdexcept>
#include <string>

namespace foothold::server {

class StateError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Holds the lock until it is destroyed, or until the process ends in whatever way.
class StateFolder {
 public:
  // Throws StateError: cannot be made or written, or another server uses it.
  explicit StateFolder(std::string path);
  ~StateFolder();
  StateFolder(const StateFolder&) = delete;
  StateFolder& operator=(const StateFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string journal() const { return path_ + "/journal.db"; }
  std::string scenes() const { return path_ + "/scenes"; }
  std::string bundles() const { return path_ + "/bundles"; }

 private:
  std::string path_;
  int lock_ = -1;
};

}  // namespace foothold::server
