// Ids: 16 octets, random, written as 32 lower-case hexadecimal digits.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace foothold::msg {

using Id = std::array<std::uint8_t, 16>;

inline constexpr Id kNoId{};

// From the operating system's random source. Any thread.
Id random_id();
// The first 16 octets of the SHA-256 of `text`: the same text, the same id.
Id id_of(std::string_view text);
std::string to_hex(const Id& id);
// Nothing unless `text` is 32 hexadecimal digits.
std::optional<Id> id_from_hex(std::string_view text);
// SHA-256 as 64 lower-case hexadecimal digits.
std::string sha256_hex(std::string_view bytes);

struct IdHash {
  std::size_t operator()(const Id& id) const noexcept;
};

}  // namespace foothold::msg
