// The server's folder on disk.
#include "state_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace foothold::server {

StateFolder::StateFolder(std::string path) : path_(std::move(path)) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) throw StateError(path_ + ": the state folder cannot be made: " + error.message());
  const std::string file = path_ + "/lock";
  // Workers must not inherit it: they may outlive the server for a moment.
  lock_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock_ < 0) throw StateError(file + ": cannot be written: " + std::strerror(errno));
  if (::flock(lock_, LOCK_EX | LOCK_NB) == 0) return;
  ::close(lock_);
  throw StateError(path_ + ": another footholdd uses this state folder; give this one another (--state-dir)");
}

StateFolder::~StateFolder() { ::close(lock_); }

}  // namespace foothold::server
