// See small_disk.hpp.
#include "small_disk.hpp"

#include <sched.h>
#include <sys/mount.h>
#include <sys/statvfs.h>

#include <string>

namespace foothold::faults {
namespace {

constexpr char kSize[] = "size=4g";

}  // namespace

SmallDisk::SmallDisk(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::filesystem::create_directories(folder_);
  // What is mounted here is seen by this process and what it starts, and goes with them.
  mounted_ = ::unshare(CLONE_NEWNS) == 0 && ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
             ::mount("tmpfs", folder_.c_str(), "tmpfs", MS_NOSUID | MS_NODEV, kSize) == 0;
}

SmallDisk::~SmallDisk() {
  if (mounted_) ::umount2(folder_.c_str(), MNT_DETACH);
}

bool SmallDisk::fill() {
  struct statvfs now {};
  if (!mounted_ || ::statvfs(folder_.c_str(), &now) != 0) return false;
  // The server may write in between: then a little more.
  for (unsigned long spare = 0; spare < 2000; spare += 100) {
    const std::string size = "size=" + std::to_string((now.f_blocks - now.f_bfree + spare) * now.f_frsize);
    if (::mount("tmpfs", folder_.c_str(), "tmpfs", MS_REMOUNT | MS_NOSUID | MS_NODEV, size.c_str()) == 0) return true;
    ::statvfs(folder_.c_str(), &now);
  }
  return false;
}

bool SmallDisk::empty() {
  return mounted_ && ::mount("tmpfs", folder_.c_str(), "tmpfs", MS_REMOUNT | MS_NOSUID | MS_NODEV, kSize) == 0;
}

}  // namespace foothold::faults
