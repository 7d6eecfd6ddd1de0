// The shipped robot on slopes: what the tests of Hex-piderix share.
#pragma once

#include <numbers>

#include "foothold/robot_file.hpp"
#include "hexpiderix/strategies/strategies.hpp"

namespace foothold::hexpiderix::testing {

inline constexpr double kDegree = std::numbers::pi / 180;

inline const Model& shipped_model() {
  static const Model model = Model::from_model(load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hexpiderix.yaml"));
  return model;
}

// The ground tilted by `slope` so that it falls towards `direction` (rad) under a robot that kept its joints; leg 1 along +X.
inline Situation tilted(double slope, double direction, Legs supports) {
  const Plane plane = tilted_plane(slope, direction);
  return {plane, standing_footholds(shipped_model(), plane, Vector3d::Zero(), 0.0, supports),
          standing_thorax(shipped_model(), plane, Vector3d::Zero(), 0.0), 0.0};
}

}  // namespace foothold::hexpiderix::testing
