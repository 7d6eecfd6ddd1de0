// The shipped robot: what the tests of Bioloid share.
#pragma once

#include <numbers>

#include "bioloid/model/kinematics.hpp"
#include "foothold/robot_file.hpp"

namespace foothold::bioloid::testing {

inline constexpr double kDegree = std::numbers::pi / 180;
inline constexpr const char* kRobotFile = FOOTHOLD_CONFIG_DIR "/robots/bioloid.yaml";

inline const Model& shipped_model() {
  static const Model model = Model::from_model(load_robot_model(kRobotFile));
  return model;
}

}  // namespace foothold::bioloid::testing
