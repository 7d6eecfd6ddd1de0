// systemd's journal as a program that is started meanwhile sees it: /run/systemd/journal/socket, in a mount namespace of the test's
// own, which takes root.
#pragma once

#include <sched.h>
#include <sys/mount.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstring>
#include <string>

namespace foothold::test {

// Thread rule: the main thread, whose /run stays an empty one afterwards.
class JournalSocket {
 public:
  JournalSocket() {
    if (::unshare(CLONE_NEWNS) != 0 || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        ::mount("tmpfs", "/run", "tmpfs", 0, nullptr) != 0)
      return;
    ::mkdir("/run/systemd", 0755);
    ::mkdir("/run/systemd/journal", 0755);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strcpy(address.sun_path, "/run/systemd/journal/socket");
    fd_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (::bind(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) ::close(std::exchange(fd_, -1));
  }
  ~JournalSocket() {
    if (fd_ >= 0) ::close(fd_);
  }
  JournalSocket(const JournalSocket&) = delete;
  JournalSocket& operator=(const JournalSocket&) = delete;

  bool is_there() const { return fd_ >= 0; }
  // The next entry, "FIELD=value" lines, that holds `line` whole; empty if none comes within `seconds`.
  std::string next(const std::string& line, double seconds = 20.0) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (Clock::now() < end) {
      const timeval wait{0, 50000};
      ::setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &wait, sizeof wait);
      std::array<char, 65536> text{};
      const ssize_t count = ::recv(fd_, text.data(), text.size(), 0);
      if (count <= 0) continue;
      const std::string entry = "\n" + std::string(text.data(), static_cast<std::size_t>(count));
      if (entry.find("\n" + line + "\n") != std::string::npos) return entry;
    }
    return {};
  }

 private:
  int fd_ = -1;
};

}  // namespace foothold::test
