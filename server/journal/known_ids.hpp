// A filter over the ids of the journal: says of most new ids at once that they are new (Bloom 1970).
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "foothold/msg/ids.hpp"

namespace foothold::server {

// With a million ids about 1 of 500 new ones is taken for a known one; the database then tells. Ids are random, so that their own
// octets are the hashes. Never grows, never forgets.
class KnownIds {
 public:
  void add(const msg::Id& id) {
    for (int probe = 0; probe < kProbes; ++probe) words_[place(id, probe) / 64] |= std::uint64_t{1} << (place(id, probe) % 64);
  }
  bool may_contain(const msg::Id& id) const {
    for (int probe = 0; probe < kProbes; ++probe)
      if ((words_[place(id, probe) / 64] >> (place(id, probe) % 64) & 1U) == 0) return false;
    return true;
  }

 private:
  static constexpr int kProbes = 4;
  static constexpr std::uint32_t kBits = 1U << 24;

  static std::uint32_t place(const msg::Id& id, int probe) {
    std::uint32_t value = 0;
    std::memcpy(&value, id.data() + 4 * probe, sizeof value);
    return value % kBits;
  }

  std::vector<std::uint64_t> words_ = std::vector<std::uint64_t>(kBits / 64);
};

}  // namespace foothold::server
