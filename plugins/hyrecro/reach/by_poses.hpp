// Answers about two soles, kept by both poses to the last bit: what is asked again, by the same request or on the same scene, is
// not worked out again, and no answer depends on what was asked before. Used by one thread at a time.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <unordered_map>

#include "hyrecro/model/model.hpp"

namespace foothold::hyrecro {

template <class Answer>
class ByPoses {
 public:
  // The kept answer, or that of `ask()`. Valid until the next call.
  template <class Ask>
  const Answer& get(const Isometry3d& holding, const Isometry3d& free, const Ask& ask) {
    if (known_.size() >= kMost) known_.clear();
    const Key key = key_of(holding, free);
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    return known_.emplace(key, ask()).first->second;
  }

 private:
  static constexpr std::size_t kMost = 20'000;
  using Key = std::array<std::uint64_t, 24>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::uint64_t out = 3;
      for (const std::uint64_t value : key) {
        out = (out ^ value) * 0x9e3779b97f4a7c15u;
        out ^= out >> 29;
      }
      return out;
    }
  };
  static Key key_of(const Isometry3d& holding, const Isometry3d& free) {
    Key key{};
    std::size_t at = 0;
    for (const Isometry3d* pose : {&holding, &free})
      for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) key[at++] = std::bit_cast<std::uint64_t>((*pose)(row, column));
    return key;
  }

  std::unordered_map<Key, Answer, Hash> known_;
};

}  // namespace foothold::hyrecro
