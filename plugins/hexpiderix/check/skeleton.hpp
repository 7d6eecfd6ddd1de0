// Hex-piderix' points straight from a posture's numbers: the judge's own kinematics, by rotations one after the other.
#pragma once

#include <array>
#include <span>

#include "hexpiderix/model/model.hpp"

namespace foothold::hexpiderix {

// World frame, m.
struct Skeleton {
  struct Limb {
    Vector3d coxa, hip, knee, foot;
  };
  std::array<Limb, kLegs> limbs;
  std::array<Vector3d, 6> corners;  // of the thorax' middle plane
  Vector3d centre_of_mass;
};

// Precondition: 18 joints.
Skeleton skeleton(const Model& model, const Isometry3d& base, std::span<const double> joints);

}  // namespace foothold::hexpiderix
