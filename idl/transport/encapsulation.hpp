// What both vendors look at in a message's octets: the encapsulation in front and, in keyed topics, the key behind it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "foothold/transport/topics.hpp"

namespace foothold::transport {

inline constexpr std::size_t kEncapsulation = 4;
using Key = std::array<std::uint8_t, 16>;

// What keeps these octets from being a message of the topic, or nullptr: they must begin as plain XCDR1 (0x0000 big, 0x0001 little
// endian), be long enough to bear the topic's key, and not too long.
inline const char* fault_of(const TopicTraits& topic, std::span<const std::byte> message) {
  if (message.size() > kMaxMessage) return "is longer than 16 MiB";
  if (message.size() < kEncapsulation + (topic.keyed ? sizeof(Key) : 0)) return "is too short";
  if (message[0] != std::byte{0} || message[1] > std::byte{1}) return "does not begin as XCDR1";
  return nullptr;
}

inline std::string describe(const TopicTraits& topic, std::span<const std::byte> message, const char* fault) {
  return "a message of " + std::to_string(message.size()) + " octets on " + std::string(topic.name) + " " + fault;
}

// The first member of a keyed topic, a Uuid: octets, so the same in both byte orders. Precondition: long enough.
inline Key key_of(std::span<const std::byte> message) {
  Key key;
  std::memcpy(key.data(), message.data() + kEncapsulation, key.size());
  return key;
}

}  // namespace foothold::transport
