// Single supports on the right foot for the paper's algorithms: the left sole from 50 mm behind to 50 mm ahead (the paper's step).
#pragma once

#include "bioloid/paper/nine_space.hpp"
#include "poses.hpp"

namespace foothold::bioloid::testing {

struct NineCase {
  Support support;
  Joints from, to;
};

// `lift` (m) of the sole over the ground at both ends; the centre of mass over the standing sole's centre, hips 120 mm over the
// ankles.
inline NineCase nine_case(double lift) {
  const Model& model = shipped_model();
  const auto at = [&](double x) {
    Pose pose = standing(model, 0.120);
    pose.soles[1] += Vector3d(x, 0.0, lift);
    return joints_of(model, shifted(model, pose, pose.soles[0]));
  };
  Support support;
  support.at = Pose::at(standing(model, 0.120).soles[0]);
  return {support, at(-0.050), at(0.050)};
}

inline constexpr double kCarried = 0.010;   // lifted before and put down after: other phases
inline constexpr double kOffGround = 5e-4;  // from the ground to the ground in one go

}  // namespace foothold::bioloid::testing
