// What a request asks of Bioloid: parameters, start and goal, judged and converted.
#pragma once

#include "bioloid/ground.hpp"
#include "bioloid/steps/walk.hpp"
#include "foothold/planner.hpp"

namespace foothold::bioloid {

struct Options {
  GaitOptions gait;
  WalkOptions walk;
};

// Throws InvalidRequest for combinations that make no sense, with the parameter at fault.
Options read_options(const Parameters& parameters);

// The robot as it begins: both soles on the ground.
struct Stand {
  Feet feet;
  Joints joints = Joints::Zero();
  bool midway = true;  // the posture in which a walk begins; else it has to be taken first
};

// With joints: exactly as they say, with the torso at `start.base` or else standing on `start.contacts`. Without: midway between
// the soles of `start.contacts`, or with its feet side by side at `start.base`, a point of the ground and a heading. Throws
// InvalidRequest: nothing given, off the ground, out of reach, unbalanced.
Stand read_start(const Model& model, const Options& options, const Ground& ground, const Placement& start);
// Where both feet shall stand side by side: `goal.base`, a point of the ground with a heading or any, or both `goal.contacts`.
// Throws InvalidRequest.
FootstepGoal read_goal(const Model& model, const Placement& goal);

}  // namespace foothold::bioloid
