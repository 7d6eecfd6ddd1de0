// Text from outside.
#include "text/text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

namespace foothold::server {
namespace {

constexpr std::size_t kShown = 80;

// The length of the UTF-8 sequence at the front of `text`, or 0 if there is none.
std::size_t sequence(std::string_view text, std::uint32_t& point) {
  const auto octet = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = octet(0);
  if (first < 0x80) {
    point = first;
    return 1;
  }
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 0;
  if (length == 0 || first > 0xF4 || text.size() < length) return 0;
  point = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((octet(i) & 0xC0U) != 0x80U) return 0;
    point = (point << 6) | (octet(i) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = point >= 0xD800 && point <= 0xDFFF;
  return point < kLeast[length] || point > 0x10FFFF || surrogate ? 0 : length;
}

bool is_control(std::uint32_t point) { return point < 0x20 || (point >= 0x7F && point < 0xA0); }

// Appends the character at the front of `text`, or its first octet as \xNN; returns how many octets that took.
std::size_t take_clean(std::string_view text, std::string& out) {
  std::uint32_t point = 0;
  const std::size_t length = sequence(text, point);
  if (length != 0 && !is_control(point)) {
    out += text.substr(0, length);
    return length;
  }
  std::array<char, 8> escaped{};
  std::snprintf(escaped.data(), escaped.size(), "\\x%02x", static_cast<unsigned>(static_cast<std::uint8_t>(text[0])));
  out += escaped.data();
  return 1;
}

}  // namespace

bool is_clean_text(std::string_view text) {
  while (!text.empty()) {
    std::uint32_t point = 0;
    const std::size_t length = sequence(text, point);
    if (length == 0 || is_control(point)) return false;
    text.remove_prefix(length);
  }
  return true;
}

bool is_sha256_hex(std::string_view text) {
  return text.size() == 64 && std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

std::string cleaned(std::string_view text) {
  std::string out;
  while (!text.empty()) text.remove_prefix(take_clean(text, out));
  return out;
}

std::string quoted(std::string_view text) {
  const std::size_t whole = text.size();
  std::string out = "'";
  while (!text.empty() && out.size() <= kShown) text.remove_prefix(take_clean(text, out));
  out += '\'';
  if (!text.empty()) out += "... (" + std::to_string(whole) + " octets)";
  return out;
}

}  // namespace foothold::server
