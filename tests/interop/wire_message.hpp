// Messages to send over the wire, and how to compare what comes back.
#pragma once

#include <algorithm>
#include <random>
#include <span>

#include "random_message.hpp"

namespace foothold::interop {

// Mostly small; every tenth long; pieces of a scene of any size that is allowed.
template <class Message>
Message random_message(std::uint64_t seed) {
  const bool is_long = seed % 10 == 0;
  auto message = test::RandomContents(seed, {.items = is_long ? 20U : 4U, .characters = is_long ? 500U : 12U}).make<Message>();
  if constexpr (std::is_same_v<Message, msg::SceneChunk>) {
    std::mt19937_64 random(seed);
    message.data().resize(is_long ? 65536 : random() % 65536);
    for (std::uint8_t& octet : message.data()) octet = static_cast<std::uint8_t>(random());
  }
  return message;
}

// Within a keyed topic the order holds for each key only.
template <class Message>
void sort_by_key(std::span<Message> messages) {
  if constexpr (requires(const Message& message) { message.key(); } && !std::is_same_v<Message, msg::SceneStatus>) {
    std::sort(messages.begin(), messages.end(), [](const Message& a, const Message& b) { return a.key() < b.key(); });
  }
}

}  // namespace foothold::interop
