// One GET of a page on loopback, as a scraper does it.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace foothold::test {

struct Page {
  int status = 0;  // 0: no answer
  std::string body;
};

inline Page http_get(std::uint16_t port, const std::string& path) {
  const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(port);
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const timeval limit{10, 0};  // for a stuck test
  ::setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
  std::string text;
  if (::connect(fd, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0) {
    const std::string request = "GET " + path + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
    [[maybe_unused]] const ssize_t sent = ::send(fd, request.data(), request.size(), MSG_NOSIGNAL);
    std::array<char, 4096> piece{};
    for (ssize_t count = 0; (count = ::recv(fd, piece.data(), piece.size(), 0)) > 0;)
      text.append(piece.data(), static_cast<std::size_t>(count));
  }
  ::close(fd);
  const auto head_end = text.find("\r\n\r\n");
  if (head_end == std::string::npos) return {};
  return {std::atoi(text.c_str() + 9), text.substr(head_end + 4)};
}

// The value of a Prometheus sample by its whole left side; -1 if it is not there.
inline double sample(const std::string& text, const std::string& name) {
  for (std::size_t at = 0; (at = text.find(name + " ", at)) != std::string::npos; at += name.size())
    if (at == 0 || text[at - 1] == '\n') return std::atof(text.c_str() + at + name.size());
  return -1.0;
}

}  // namespace foothold::test
