// recv and send with their interruptions and short counts.
#include "worker/channel.hpp"

#include <sys/socket.h>

#include <cerrno>

namespace foothold::server {

bool Channel::receive(int flags) {
  for (;;) {
    const auto room = in_.room();
    const ssize_t count = ::recv(descriptor_, room.data(), room.size(), flags);
    if (count > 0) {
      in_.filled(static_cast<std::size_t>(count));
      return true;
    }
    if (count < 0 && errno == EINTR) continue;
    // Every other error means that the other end is gone.
    if (count == 0 || (errno != EAGAIN && errno != EWOULDBLOCK)) ended_ = true;
    return false;
  }
}

std::optional<Frame> Channel::read() {
  for (;;) {
    if (auto frame = in_.next()) return frame;
    if (!receive(0) && ended_) return std::nullopt;
  }
}

std::optional<Frame> Channel::take() {
  for (;;) {
    if (auto frame = in_.next()) return frame;
    if (!receive(MSG_DONTWAIT)) return std::nullopt;
  }
}

void Channel::send_out() {
  std::size_t sent = 0;
  while (sent < out_.size()) {
    const ssize_t count = ::send(descriptor_, out_.data() + sent, out_.size() - sent, MSG_NOSIGNAL);
    if (count >= 0)
      sent += static_cast<std::size_t>(count);
    else if (errno != EINTR)
      throw ChannelClosed();
  }
}

}  // namespace foothold::server
