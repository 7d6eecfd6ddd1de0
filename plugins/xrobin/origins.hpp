// The merged half cycles read backwards: every way in which a pose comes about, not only the first.
#pragma once

#include <span>

#include "half_cycles.hpp"

namespace foothold::xrobin {

// For each pose of each level all pairs (pose below, configuration) that lead to it. Immutable; any thread.
class Origins {
 public:
  // The levels up to `level` must have been made.
  Origins(const HalfCycles& half_cycles, int level);
  // Codes 8 * (index in the level below) + configuration - 1.
  std::span<const std::uint32_t> of(int level, std::uint32_t id) const;
  int levels() const { return static_cast<int>(levels_.size()) - 1; }

 private:
  struct Level {
    std::vector<std::uint32_t> begin;
    std::vector<std::uint32_t> codes;
  };
  std::vector<Level> levels_;
};

}  // namespace foothold::xrobin
