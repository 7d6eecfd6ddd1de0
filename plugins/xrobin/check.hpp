// Judges a step of Xrobin from poses and piston lengths alone: no tables and no curves of the search.
#pragma once

#include "foothold/planner.hpp"
#include "mechanism.hpp"

namespace foothold::xrobin {

// Judges `step` after `before`: what holds did not move, B stays in A's slot, both pistons are as long as their pins are apart,
// one piston at a time moves between its two lengths, and no posture on the way is singular.
StepVerdict check_step(const Lengths& lengths, const Step& step, const Posture& before);

}  // namespace foothold::xrobin
