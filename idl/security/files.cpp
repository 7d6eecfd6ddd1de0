// Modes are set when files are made, not afterwards.
#include "files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace foothold::security {
namespace fs = std::filesystem;

namespace {

SecurityError fault(const fs::path& path, const char* what, int number) {
  return SecurityError(path.string() + ": " + what + ": " + std::strerror(number));
}

void write_all(int descriptor, const std::string& text, const fs::path& path) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t written = ::write(descriptor, text.data() + done, text.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw fault(path, "cannot be written", errno);
    done += static_cast<std::size_t>(written);
  }
  if (::fsync(descriptor) != 0) throw fault(path, "cannot be written", errno);
}

}  // namespace

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    const int number = errno;
    throw fault(path, "cannot be read", number);
  }
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_new(const fs::path& path, const std::string& text, Access access) {
  const auto mode = static_cast<mode_t>(access);
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (descriptor < 0) throw fault(path, "cannot be made", errno);
  try {
    if (::fchmod(descriptor, mode) != 0) throw fault(path, "cannot be made", errno);
    write_all(descriptor, text, path);
  } catch (...) {
    ::close(descriptor);
    ::unlink(path.c_str());
    throw;
  }
  ::close(descriptor);
}

void replace(const fs::path& path, const std::string& text, Access access) {
  const fs::path next = path.string() + ".new";
  std::error_code ignored;
  fs::remove(next, ignored);
  write_new(next, text, access);
  if (::rename(next.c_str(), path.c_str()) != 0) throw fault(path, "cannot be replaced", errno);
}

void make_private_folder(const fs::path& path) {
  std::error_code error;
  if (fs::exists(path, error)) {
    if (!fs::is_directory(path, error) || !fs::is_empty(path, error))
      throw SecurityError(path.string() + ": is there already; nothing is overwritten: name a folder that is new or empty");
    if (::chmod(path.c_str(), 0700) != 0) throw fault(path, "cannot be closed to others", errno);
    return;
  }
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  if (::mkdir(path.c_str(), 0700) != 0) throw fault(path, "cannot be made", errno);
}

Unfinished::~Unfinished() {
  std::error_code ignored;
  if (!kept_) fs::remove_all(folder_, ignored);
}

}  // namespace foothold::security
