// The worker's end of the socket pair: whole frames in, whole frames out.
//
// Thread rule: send() by one thread at a time; read() and take() by one thread at a time, which may be another one.
#pragma once

#include <optional>
#include <stdexcept>

#include "frames/frames.hpp"

namespace foothold::server {

// The daemon is gone: nothing that this process could say would be heard.
class ChannelClosed : public std::runtime_error {
 public:
  ChannelClosed() : std::runtime_error("the daemon closed the channel") {}
};

class Channel {
 public:
  // Does not own the descriptor, which must be a connected stream socket in blocking mode.
  explicit Channel(int descriptor) : descriptor_(descriptor) {}

  // The next frame; waits for it. Nothing when the daemon closed its end. Throws FrameFault.
  std::optional<Frame> read();

  // The next frame if it is there already. Nothing otherwise, and then `ended()` tells whether there will ever be one.
  std::optional<Frame> take();
  bool ended() const { return ended_; }

  // Sends at once and waits while the daemon's buffer is full. Throws ChannelClosed. Keeps one buffer for all messages.
  template <class Message>
  void send(frame::WorkerFrame kind, std::uint64_t run, const Message& message) {
    encode_frame(kind, run, message, out_);
    send_out();
  }

  // Whether one frame may hold this message.
  template <class Message>
  bool fits(const Message& message) const {
    return Message::getCdrSerializedSize(message) + 4 <= kLargestPayload;
  }

  int descriptor() const { return descriptor_; }

 private:
  void send_out();
  bool receive(int flags);

  int descriptor_;
  bool ended_ = false;
  FrameReader in_;
  msg::Bytes out_;
};

}  // namespace foothold::server
