// Ids and hashes.
#include "foothold/msg/ids.hpp"

#include <openssl/evp.h>
#include <sys/random.h>

#include <cstring>
#include <stdexcept>

namespace foothold::msg {
namespace {

constexpr char kDigits[] = "0123456789abcdef";

std::array<std::uint8_t, 32> sha256(std::string_view bytes) {
  std::array<std::uint8_t, 32> digest{};
  unsigned length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("SHA-256 is not available in the installed OpenSSL");
  return digest;
}

template <std::size_t N>
std::string hex(const std::array<std::uint8_t, N>& octets) {
  std::string text;
  text.reserve(2 * N);
  for (const std::uint8_t octet : octets) {
    text += kDigits[octet >> 4];
    text += kDigits[octet & 15];
  }
  return text;
}

int digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

Id random_id() {
  Id id{};
  if (getrandom(id.data(), id.size(), 0) != static_cast<ssize_t>(id.size()))
    throw std::runtime_error("getrandom gave no random octets");
  return id;
}

Id id_of(std::string_view text) {
  const auto digest = sha256(text);
  Id id{};
  std::memcpy(id.data(), digest.data(), id.size());
  return id;
}

std::string to_hex(const Id& id) { return hex(id); }

std::optional<Id> id_from_hex(std::string_view text) {
  if (text.size() != 32) return std::nullopt;
  Id id{};
  for (std::size_t i = 0; i < id.size(); ++i) {
    const int high = digit(text[2 * i]);
    const int low = digit(text[2 * i + 1]);
    if (high < 0 || low < 0) return std::nullopt;
    id[i] = static_cast<std::uint8_t>(16 * high + low);
  }
  return id;
}

std::string sha256_hex(std::string_view bytes) { return hex(sha256(bytes)); }

std::size_t IdHash::operator()(const Id& id) const noexcept {
  std::size_t value = 0;  // ids are random: any octets of theirs are a good hash
  std::memcpy(&value, id.data(), sizeof value);
  return value;
}

}  // namespace foothold::msg
