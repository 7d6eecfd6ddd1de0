// Where a number of cycles can bring body A: the workspace of the paper's figure 3, each pose once.
#pragma once

#include "half_cycles.hpp"

namespace foothold::xrobin {

// The poses of body A after exactly `cycles` cycles, in its frame before them: 55 for one, 2427 for two with the printed lengths,
// where the paper counts 64 and 4096 words. Shorter plans are among them, since a cycle may go nowhere. The half cycles must have
// been grown to level 2 * cycles, so 4 cycles at most; density.hpp counts the words of more.
std::vector<PlanarPose> workspace(const HalfCycles& half_cycles, int cycles);

}  // namespace foothold::xrobin
