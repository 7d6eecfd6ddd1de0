// Motions through postures by hand.
#pragma once

#include <vector>

#include "physics/walking.hpp"
#include "poses.hpp"

namespace foothold::bioloid::testing {

// Straight lines of torso and soles between poses, a posture every 2 mm.
physics::JointPath motion_through(const Model& model, const std::vector<Pose>& poses);

// The paper's gait by hand: shift, lift `height` and forward, down; with feet brought together by the last of `steps` steps.
std::vector<Pose> walk_by_hand(const Model& model, int steps, double length, double height);

}  // namespace foothold::bioloid::testing
