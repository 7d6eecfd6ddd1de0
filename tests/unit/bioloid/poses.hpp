// Postures by hand, without any planner: where the level torso and both soles are, and the legs in closed form.
#pragma once

#include <stdexcept>

#include "robot.hpp"

namespace foothold::bioloid::testing {

// Level bodies in the world: places of the torso's frame and of both soles.
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

// The torso moved level, so that the centre of mass comes to lie over `over` (x, y).
inline Pose shifted(const Model& model, Pose pose, const Vector3d& over) {
  // The legs move with the torso: a few corrections until they do not matter any more.
  for (int k = 0; k < 20; ++k) {
    Vector3d left = over - pose.torso - centre_of_mass(model, joints_of(model, pose));
    left.z() = 0.0;
    pose.torso += left;
  }
  return pose;
}

// Feet side by side under the hips, hips `height` (m) over the ankles, the centre of mass over the middle.
inline Pose standing(const Model& model, double height, double x = 0.0) {
  Pose out;
  for (const Side side : {Side::kRight, Side::kLeft}) out.soles[index_of(side)] = {x, model.hip(side).y(), 0.0};
  const double hip = model.hip(Side::kRight).z(), sole = model.sole(Side::kRight).z();
  out.torso = {x, 0.0, height - hip - sole};
  return shifted(model, out, {x, 0.0, 0.0});
}

}  // namespace foothold::bioloid::testing
