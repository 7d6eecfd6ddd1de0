// What a service tells its supervisor: the other end of NOTIFY_SOCKET (sd_notify(3)), for programs that are started while it lives.
#pragma once

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "temporary_folder.hpp"

namespace foothold::test {

// Thread rule: one thread.
class NotifySocket {
 public:
  NotifySocket() : fd_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string path = folder_ / "notify";
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    if (::bind(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) throw std::runtime_error("bind " + path);
    ::setenv("NOTIFY_SOCKET", path.c_str(), 1);
  }
  ~NotifySocket() {
    ::unsetenv("NOTIFY_SOCKET");
    ::close(fd_);
  }
  NotifySocket(const NotifySocket&) = delete;
  NotifySocket& operator=(const NotifySocket&) = delete;

  // The next message that begins so, others left out; empty if none comes within `seconds`.
  std::string next(const std::string& beginning, double seconds = 20.0) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (Clock::now() < end) {
      const timeval wait{0, 50000};
      ::setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &wait, sizeof wait);
      std::array<char, 4096> text{};
      const ssize_t count = ::recv(fd_, text.data(), text.size(), 0);
      if (count <= 0) continue;
      const std::string message(text.data(), static_cast<std::size_t>(count));
      if (message.starts_with(beginning)) return message;
    }
    return {};
  }

 private:
  TemporaryFolder folder_;
  int fd_;
};

}  // namespace foothold::test
