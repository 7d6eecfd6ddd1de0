// What both vendors look at in a message's octets: the encapsulation in front and, in keyed topics, the key behind it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "foothold/transport/topics.hpp"

namespace foothold::transport {

inline constexpr std::size_t kEncapsulation = 4;
using Key = std::array<std::uint8_t, 16>;

// True if the octets begin as plain XCDR1 (0x0000 big, 0x0001 little endian) and are long enough to bear the topic's key.
inline bool looks_like(const TopicTraits& topic, std::span<const std::byte> message) {
  if (message.size() < kEncapsulation + (topic.keyed ? sizeof(Key) : 0)) return false;
  return message[0] == std::byte{0} && (message[1] == std::byte{0} || message[1] == std::byte{1});
}

// The first member of a keyed topic, a Uuid: octets, so the same in both byte orders. Precondition: long enough.
inline Key key_of(std::span<const std::byte> message) {
  Key key;
  std::memcpy(key.data(), message.data() + kEncapsulation, key.size());
  return key;
}

}  // namespace foothold::transport
