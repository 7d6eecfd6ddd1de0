// The 64 cycles, equal ends together.
#include "modules.hpp"

#include <algorithm>

namespace foothold::xrobin {

std::vector<Module> modules(const Mechanism& mechanism) {
  std::vector<Module> out;
  for (std::uint8_t first = 1; first <= kConfigurations; ++first)
    for (std::uint8_t second = 1; second <= kConfigurations; ++second) {
      const PlanarPose end = mechanism.b_in_a(first) * inverse(mechanism.b_in_a(second));
      auto same = std::find_if(out.begin(), out.end(), [&](const Module& m) {
        return distance(m.end, end) < 1e-12 && std::abs(wrapped(m.end.heading - end.heading)) < 1e-12;
      });
      if (same == out.end()) same = out.insert(same, {end, std::cos(end.heading), std::sin(end.heading), {}});
      same->pairs.push_back({first, second});
    }
  return out;
}

}  // namespace foothold::xrobin
