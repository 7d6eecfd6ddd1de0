// The octopod's points and bodies straight from a posture's numbers: the judge's own kinematics, by rotations one after the other.
#pragma once

#include <array>
#include <span>

#include "octopod/model/model.hpp"

namespace foothold::octopod {

// World frame, m.
struct Skeleton {
  struct Limb {
    Vector3d hip = Vector3d::Zero(), knee = Vector3d::Zero(), foot = Vector3d::Zero();
    Vector3d ankle = Vector3d::Zero();  // where the tibia ends and the foot begins
  };
  std::array<Isometry3d, 2> module;
  Vector3d joint = Vector3d::Zero();  // C
  std::array<Limb, kLegs> limbs;
  Vector3d centre_of_mass = Vector3d::Zero();
};

// `joints`: 27, as the interface orders them.
Skeleton skeleton(const Model& model, const Isometry3d& base, std::span<const double> joints);

}  // namespace foothold::octopod
