// A step by closed form alone: the centre of mass over one foot, the other lifted, carried and put down, the centre of mass back.
#pragma once

#include <vector>

#include "bioloid/check/check.hpp"
#include "robot.hpp"

namespace foothold::bioloid::testing {

struct StepOrder {
  Side moving = Side::kLeft;
  double forward = 0.05, lift = 0.01, turn = 0.0;  // m, m, rad
  double pelvis = 0.195;                           // m over the ground
  double beside = 0.0;                             // m, of the centre of mass off the standing foot's middle, outwards
};

// Both soles and the centre of mass over a point: joints and base. Throws if out of reach.
Coordinates standing_with(const Model& model, const Isometry3d& right, const Isometry3d& left, const Eigen::Vector2d& centre,
                          double pelvis, double heading);

Posture standing(const Model& model, double pelvis = 0.195);
// From `before`, which stands on both feet.
Step step_after(const Model& model, const Posture& before, const StepOrder& order);

}  // namespace foothold::bioloid::testing
