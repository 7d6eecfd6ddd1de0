// Frames of idl/worker.idl on a stream of octets: a header of 16 octets, then the payload. Both ends of the socket pair use this.
//
// Whoever reads is not at the mercy of whoever writes: lengths and kinds are judged before anything is stored.
#pragma once

#include <worker.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "foothold/msg/cdr.hpp"
#include "foothold/msg/ids.hpp"

namespace foothold::server {

inline constexpr std::size_t kFrameHeader = 16;
inline constexpr std::uint32_t kLargestPayload = 16u << 20;  // octets; a step or a scene's geometry beyond it is not sent

// The stream does not hold frames. The message says what was found.
class FrameFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Frame {
  frame::WorkerFrame kind;
  std::uint64_t run;                   // 0 for frames of no run
  std::span<const std::byte> payload;  // lives until the reader is used again
};

// For messages: "STEP", or "frame kind 9".
std::string frame_name(frame::WorkerFrame kind);

// Puts the header into the first kFrameHeader octets of `frame`, whose other octets are the payload.
void seal_frame(frame::WorkerFrame kind, std::uint64_t run, msg::Bytes& frame);

// A whole frame with its message. Keeps the capacity of `out`.
template <class Message>
void encode_frame(frame::WorkerFrame kind, std::uint64_t run, const Message& message, msg::Bytes& out) {
  msg::encode_into(message, out, kFrameHeader);
  seal_frame(kind, run, out);
}

// Cuts a stream into frames. Any thread, one at a time.
class FrameReader {
 public:
  // Where the next octets go: never empty. Invalidates every payload given out.
  std::span<std::byte> room();
  void filled(std::size_t octets) { end_ += octets; }
  // The next whole frame, or nothing until more octets are there. Throws FrameFault; the stream is then lost.
  std::optional<Frame> next();
  bool empty() const { return begin_ == end_; }

 private:
  msg::Bytes buffer_ = msg::Bytes(64u << 10);
  std::size_t begin_ = 0, end_ = 0;
  std::size_t wanted_ = kFrameHeader;  // octets from begin_ on until the next frame is whole
};

// What the first octets of a step's CDR say, read in place: the daemon passes steps on without decoding them.
struct StepHead {
  msg::Id request;
  std::uint32_t index;
};
// Nothing unless the octets begin like little-endian CDR of foothold::msg::Step.
std::optional<StepHead> peek_step(std::span<const std::byte> step);

}  // namespace foothold::server
