// Counting sort of the successors.
#include "origins.hpp"

#include <numeric>

namespace foothold::xrobin {

Origins::Origins(const HalfCycles& half_cycles, int level) {
  levels_.resize(static_cast<std::size_t>(level) + 1);
  for (int n = 1; n <= level; ++n) {
    const std::vector<std::uint32_t>& next = half_cycles.level(n - 1).next;
    Level& out = levels_[static_cast<std::size_t>(n)];
    out.begin.assign(half_cycles.level(n).size() + 1, 0);
    for (const std::uint32_t id : next) ++out.begin[id + 1];
    std::partial_sum(out.begin.begin(), out.begin.end(), out.begin.begin());
    out.codes.resize(next.size());
    std::vector<std::uint32_t> at(out.begin.begin(), out.begin.end() - 1);
    for (std::uint32_t code = 0; code < next.size(); ++code) out.codes[at[next[code]]++] = code;
  }
}

std::span<const std::uint32_t> Origins::of(int level, std::uint32_t id) const {
  const Level& at = levels_[static_cast<std::size_t>(level)];
  return {at.codes.data() + at.begin[id], at.begin[id + 1] - at.begin[id]};
}

}  // namespace foothold::xrobin
