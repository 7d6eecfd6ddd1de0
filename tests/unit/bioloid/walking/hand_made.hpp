// Motions made by hand, without any planner: where the torso and both soles are, and the legs in closed form.
#pragma once

#include <stdexcept>
#include <vector>

#include "bioloid/model/kinematics.hpp"
#include "physics/walking.hpp"

namespace foothold::bioloid::testing {

// Level bodies in the world: places of the torso's frame and of both soles, and how the soles are turned about Z.
struct Pose {
  Vector3d torso = Vector3d::Zero();
  Vector3d soles[2] = {Vector3d::Zero(), Vector3d::Zero()};  // right, left

  static Isometry3d at(const Vector3d& place) { return Isometry3d(Eigen::Translation3d(place)); }
};

inline Joints joints_of(const Model& model, const Pose& pose) {
  Joints out = model.carrying;
  for (const Side side : {Side::kRight, Side::kLeft})
    if (!reach(model, side, Pose::at(pose.soles[index_of(side)] - pose.torso), out))
      throw std::runtime_error("a pose out of reach");
  return out;
}

// Feet side by side under the hips, hips `height` (m) over the ankles, the centre of mass over the middle.
Pose standing(const Model& model, double height, double x = 0.0);
// The torso moved level, so that the centre of mass comes to lie over `over` (x, y).
Pose shifted(const Model& model, Pose pose, const Vector3d& over);

// Straight lines of torso and soles between poses, a posture every 2 mm.
physics::JointPath motion_through(const Model& model, const std::vector<Pose>& poses);

// The paper's gait by hand: shift, lift `height` and forward, down; with feet brought together by the last of `steps` steps.
std::vector<Pose> walk_by_hand(const Model& model, int steps, double length, double height);

}  // namespace foothold::bioloid::testing
