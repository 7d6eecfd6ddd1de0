// Messages for tests that only count: the bus looks at the encapsulation (and a key), not at the rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace foothold::test {

// `size` octets in all, 24 or more: encapsulation, a key of zeros, the number.
inline std::vector<std::byte> numbered(std::uint32_t number, std::size_t size) {
  std::vector<std::byte> message(size, std::byte{0});
  message[1] = std::byte{1};
  std::memcpy(message.data() + 20, &number, sizeof number);
  return message;
}

inline std::uint32_t number_of(std::span<const std::byte> message) {
  std::uint32_t number = 0;
  std::memcpy(&number, message.data() + 20, sizeof number);
  return number;
}

}  // namespace foothold::test
