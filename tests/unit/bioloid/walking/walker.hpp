// Bioloid as the physics judge takes it: bodies, masses, boxes, axes. Our soles, supports and margins stay behind.
#pragma once

#include "bioloid/model/kinematics.hpp"
#include "physics/walking.hpp"

namespace foothold::bioloid::testing {

inline physics::Walker walker_of(const Model& model) {
  physics::Walker out;
  for (std::size_t b = 0; b < kBodies; ++b) {
    const Body& body = model.bodies[b];
    physics::WalkerLink link{.name = body.name, .mass = body.mass, .centre_of_mass = body.centre_of_mass};
    if (b > 0) {
      const JointModel& joint = model.joints[b - 1];
      link.parent = joint.parent + 1;
      link.origin = joint.origin;
      link.axis = joint.axis;
    }
    for (const BodyBox& box : body.boxes) link.boxes.push_back({box.centre, box.half});
    out.links.push_back(std::move(link));
    for (std::size_t a = 0; a < b; ++a)
      if (model.neighbours(a, b)) out.excluded.emplace_back(static_cast<int>(a), static_cast<int>(b));
  }
  return out;
}

inline std::vector<int> feet_of() {
  return {static_cast<int>(leg_joint(Side::kRight, 5)) + 1, static_cast<int>(leg_joint(Side::kLeft, 5)) + 1};
}

}  // namespace foothold::bioloid::testing
