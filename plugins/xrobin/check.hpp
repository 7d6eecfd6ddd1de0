// Judges a step of Xrobin from poses and piston lengths alone: no tables and no curves of the search.
#pragma once

#include "body.hpp"
#include "foothold/planner.hpp"
#include "geometry/plane_scene.hpp"

namespace foothold::xrobin {

// Judges `step` after `before`: what holds did not move, B stays in A's slot, both pistons are as long as their pins are apart,
// one piston at a time moves between its two lengths, and no posture on the way is singular.
StepVerdict check_step(const Lengths& lengths, const Step& step, const Posture& before);

// The same among obstacles, of which bodies and pistons must stay away by `clearance` (m) during the whole step; the least distance
// is its margin where an obstacle is near.
StepVerdict check_step_among(const Lengths& lengths, const Bodies& bodies, const std::vector<geometry::Obstacle>& obstacles,
                             double clearance, const Step& step, const Posture& before);

}  // namespace foothold::xrobin
