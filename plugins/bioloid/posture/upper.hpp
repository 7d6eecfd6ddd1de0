// What the legs carry: the torso with the arms, held still on a walk, so that most of it is worked out once. Private to posture/.
#pragma once

#include <array>
#include <vector>

#include "bioloid/posture/lanes.hpp"
#include "collision/distance.hpp"

namespace foothold::bioloid {

inline constexpr std::size_t kArmJoints = 6;
using Arms = Eigen::Matrix<double, static_cast<int>(kArmJoints), 1>;  // the first joints

// In the torso's frame.
struct Upper {
  struct Part {
    std::size_t body = 0;
    collision::Box box;
  };
  Arms arms = Arms::Zero();
  std::array<Isometry3d, kArmJoints + 1> frames;  // of torso and arms
  std::vector<Part> parts;                        // torso first, then arms
  std::size_t torso_parts = 0;
  Vector3d moment = Vector3d::Zero();  // kg m about the pelvis
  double lowest = 0.0;                 // m, of the torso alone
  double reach = 0.0;                  // m, from the pelvis to the farthest corner
  // Beside each arm a plane that has all of it beyond: arm_plane . p >= arm_offset. As far from its leg as can be.
  Lanes3 arm_plane{};
  Lanes arm_offset{};
  // A box round each arm: centre, and axes as long as the half edges.
  Lanes3 arm_centre{};
  std::array<Lanes3, 3> arm_axes{};
  bool apart = true;  // no two of these bodies are nearer than the clearance
};

Upper upper_of(const Model& model, const Arms& arms, double clearance);

// From a shoulder to the farthest corner of its arm however it is held, m.
double arm_reach(const Model& model);

}  // namespace foothold::bioloid
