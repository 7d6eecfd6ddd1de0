// What a test and its peer processes say to each other through pipes: a kind, a length, octets.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

namespace foothold::test {

enum class Kind : std::uint8_t { kReady, kMessage, kMatched, kAlive };

struct Frame {
  Kind kind = Kind::kReady;
  std::vector<std::byte> octets;  // of kMatched and kAlive: the number, one std::uint64_t
  std::uint64_t number() const {
    std::uint64_t value = 0;
    if (octets.size() == sizeof value) std::memcpy(&value, octets.data(), sizeof value);
    return value;
  }
};

inline bool put_all(int file, const void* from, std::size_t size) {
  const auto* octets = static_cast<const std::byte*>(from);
  while (size > 0) {
    const ssize_t written = ::write(file, octets, size);
    if (written <= 0) return false;
    octets += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

inline bool get_all(int file, void* into, std::size_t size) {
  auto* octets = static_cast<std::byte*>(into);
  while (size > 0) {
    const ssize_t got = ::read(file, octets, size);
    if (got <= 0) return false;
    octets += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

inline bool put_frame(int file, Kind kind, std::span<const std::byte> octets) {
  std::vector<std::byte> frame(1 + sizeof(std::uint32_t) + octets.size());
  const auto size = static_cast<std::uint32_t>(octets.size());
  frame[0] = static_cast<std::byte>(kind);
  std::memcpy(frame.data() + 1, &size, sizeof size);
  if (size > 0) std::memcpy(frame.data() + 1 + sizeof size, octets.data(), size);
  return put_all(file, frame.data(), frame.size());
}

inline bool put_number(int file, Kind kind, std::uint64_t number) {
  return put_frame(file, kind, std::as_bytes(std::span(&number, 1)));
}

// Nothing at the end of the file.
inline std::optional<Frame> get_frame(int file) {
  Frame frame;
  std::uint32_t size = 0;
  if (!get_all(file, &frame.kind, 1) || !get_all(file, &size, sizeof size)) return std::nullopt;
  frame.octets.resize(size);
  if (!get_all(file, frame.octets.data(), size)) return std::nullopt;
  return frame;
}

}  // namespace foothold::test
