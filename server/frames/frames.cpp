// The header's octets, and cutting a stream at them.
#include "frames/frames.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace foothold::server {
namespace {

static_assert(std::endian::native == std::endian::little, "frames and CDR are written as they lie in memory");

struct Header {
  std::uint32_t length;
  std::uint32_t kind;
  std::uint64_t run;
};
static_assert(sizeof(Header) == kFrameHeader);

constexpr std::array<const char*, 8> kNames = {"LOAD", "PLAN", "STOP", "READY", "REFUSED", "SCENE", "STEP", "REPORT"};

// More room than one frame needs lets one read take many small frames.
constexpr std::size_t kLeastRoom = 4096;
// A frame's length is a promise: beyond this, room is made as octets arrive.
constexpr std::size_t kTrusted = 16u << 10;
// One huge step shall not cost its memory for ever.
constexpr std::size_t kKeptBuffer = 1u << 20;

}  // namespace

std::string frame_name(frame::WorkerFrame kind) {
  const auto number = static_cast<std::size_t>(kind);
  return number < kNames.size() ? kNames[number] : "frame kind " + std::to_string(number);
}

void seal_frame(frame::WorkerFrame kind, std::uint64_t run, msg::Bytes& frame) {
  if (frame.size() < kFrameHeader) frame.resize(kFrameHeader);
  const Header header{static_cast<std::uint32_t>(frame.size() - kFrameHeader), static_cast<std::uint32_t>(kind), run};
  std::memcpy(frame.data(), &header, sizeof(header));
}

std::span<std::byte> FrameReader::room() {
  if (begin_ == end_) begin_ = end_ = 0;
  if (end_ == 0 && buffer_.size() > kKeptBuffer && wanted_ < kKeptBuffer) {
    buffer_.resize(kKeptBuffer);
    buffer_.shrink_to_fit();
  }
  const std::size_t missing = wanted_ > end_ - begin_ ? wanted_ - (end_ - begin_) : 0;
  const std::size_t needed = std::max(std::min(missing, std::max(end_ - begin_, kTrusted)), kLeastRoom);
  if (buffer_.size() - end_ < needed) {
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_), buffer_.begin() + static_cast<std::ptrdiff_t>(end_),
              buffer_.begin());
    end_ -= begin_;
    begin_ = 0;
    if (buffer_.size() - end_ < needed) buffer_.resize(end_ + needed);
  }
  return std::span(buffer_).subspan(end_);
}

std::optional<Frame> FrameReader::next() {
  if (end_ - begin_ < kFrameHeader) {
    wanted_ = kFrameHeader;
    return std::nullopt;
  }
  Header header{};
  std::memcpy(&header, buffer_.data() + begin_, sizeof(header));
  if (header.kind >= kNames.size()) throw FrameFault("a frame of unknown kind " + std::to_string(header.kind));
  if (header.length > kLargestPayload)
    throw FrameFault("a " + frame_name(static_cast<frame::WorkerFrame>(header.kind)) + " frame of " +
                     std::to_string(header.length) + " octets, at most " + std::to_string(kLargestPayload) + " are allowed");
  wanted_ = kFrameHeader + header.length;
  if (end_ - begin_ < wanted_) return std::nullopt;
  const Frame frame{static_cast<frame::WorkerFrame>(header.kind), header.run,
                    std::span(buffer_).subspan(begin_ + kFrameHeader, header.length)};
  begin_ += wanted_;
  wanted_ = kFrameHeader;
  return frame;
}

std::optional<StepHead> peek_step(std::span<const std::byte> step) {
  constexpr std::array<std::byte, 4> kLittleEndianCdr = {std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}};
  StepHead head{};
  constexpr std::size_t kRequest = kLittleEndianCdr.size(), kServer = kRequest + head.request.size(),
                        kIndex = kServer + sizeof(msg::Id);
  if (step.size() < kIndex + sizeof(head.index)) return std::nullopt;
  if (!std::ranges::equal(step.first<4>(), kLittleEndianCdr)) return std::nullopt;
  std::memcpy(head.request.data(), step.data() + kRequest, head.request.size());
  std::memcpy(&head.index, step.data() + kIndex, sizeof(head.index));
  return head;
}

}  // namespace foothold::server
