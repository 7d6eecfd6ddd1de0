// What a peer sends to the port of figures and health, through a real connection: whatever it is, the server answers or closes, and
// the handler sees clean paths only.
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include "../fuzzing.hpp"
#include "http/http.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  static boost::asio::io_context loop;
  static server::HttpServer server(loop, "127.0.0.1", 0, [](std::string_view path) {
    fuzz::demand(path.find_first_of("?\r\n") == std::string_view::npos, "a path is one, without its query");
    return server::HttpAnswer{};
  });
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(server.port());
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int peer = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (peer < 0 || ::connect(peer, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) std::abort();
  loop.poll();
  for (std::size_t sent = 0; sent < size;) {
    const ssize_t count = ::send(peer, data + sent, size - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count <= 0) break;  // it has closed
    sent += static_cast<std::size_t>(count);
    loop.poll();
  }
  ::shutdown(peer, SHUT_WR);
  loop.poll();
  // A reset, so that no port is left waiting for a minute.
  const linger gone{1, 0};
  ::setsockopt(peer, SOL_SOCKET, SO_LINGER, &gone, sizeof gone);
  ::close(peer);
  loop.poll();
  return 0;
}
