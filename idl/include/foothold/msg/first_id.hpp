// The id at the front of a message as DDS carries it, without reading the rest.
#pragma once

#include <cstddef>
#include <cstring>
#include <optional>
#include <span>

#include "foothold/msg/ids.hpp"

namespace foothold::msg {

// Of a message whose first member is an id, such as every one about a plan: behind the four octets of encapsulation. Empty if the
// message is too short. Any thread.
inline std::optional<Id> first_id(std::span<const std::byte> message) {
  constexpr std::size_t kEncapsulation = 4;
  Id id{};
  if (message.size() < kEncapsulation + id.size()) return std::nullopt;
  std::memcpy(id.data(), message.data() + kEncapsulation, id.size());
  return id;
}

}  // namespace foothold::msg
