// The even levels of the merged half cycles.
#include "workspace.hpp"

namespace foothold::xrobin {

std::vector<PlanarPose> workspace(const HalfCycles& half_cycles, int cycles) {
  const PoseLevel& level = half_cycles.level(2 * cycles);
  std::vector<PlanarPose> out;
  out.reserve(level.size());
  for (std::size_t k = 0; k < level.size(); ++k) out.push_back({level.x[k], level.y[k], half_cycles.turns().angle(level.turn[k])});
  return out;
}

}  // namespace foothold::xrobin
