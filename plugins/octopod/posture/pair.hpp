// Both modules by the joint that they share: how postures are built and how bodies move between them. Values; any thread.
#pragma once

#include "octopod/model/body.hpp"

namespace foothold::octopod {

struct Pair {
  Vector3d joint = Vector3d::Zero();                                                              // C, m, world
  std::array<Eigen::Matrix3d, 2> turn{Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity()};  // world from module, A and B
};

Pair pair_of(const Model& model, const Coordinates& at);

// From C to what lies at `at` in the frame of module A (0) or B (1), m, module's frame.
inline Vector3d lever(const Model& model, int module, const Vector3d& at) {
  return at + Vector3d(module == 0 ? model.arm() : -model.arm(), 0, 0);
}
inline Vector3d lever(const Model& model, int leg) {
  return lever(model, module_of(leg), model.shoulders[static_cast<std::size_t>(leg % 4)]);
}
inline Vector3d shoulder(const Model& model, const Pair& pair, int leg) {
  return pair.joint + pair.turn[static_cast<std::size_t>(module_of(leg))] * lever(model, leg);
}
inline Isometry3d module_pose(const Model& model, const Pair& pair, int module) {
  Isometry3d out = Isometry3d::Identity();
  out.linear() = pair.turn[static_cast<std::size_t>(module)];
  out.translation() = pair.joint + out.linear() * lever(model, module, Vector3d::Zero());
  return out;
}

// The robot with bodies as `pair` and feet at `feet` (m, world), legs on their standing branch. Empty if a leg does not reach.
std::optional<Coordinates> reaching(const Model& model, const Pair& pair, const std::array<Vector3d, kLegs>& feet);

// Which leg misses its foot by how much (m); leg -1: none.
struct Miss {
  int leg = -1;
  double by = 0.0;
};
// Moves the bodies as little as it takes (Newton's method, least norm, on C and both orientations) until all legs reach `feet` with
// their knees a little bent (by 0.5 % of the reach). Legs that reach from where they are move nothing. C moves by `farthest` (m) at
// most. If that is not enough: the leg that missed most where the bodies were, and `pair` is not to be used.
Miss settle(const Model& model, const std::array<Vector3d, kLegs>& feet, double farthest, Pair& pair);

}  // namespace foothold::octopod
