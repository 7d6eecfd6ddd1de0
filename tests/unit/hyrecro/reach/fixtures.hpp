// HyReCRo as shipped, and random coordinates of it.
#pragma once

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include "foothold/robot_file.hpp"
#include "hyrecro/model/chain.hpp"

namespace foothold::hyrecro {

inline const Model& robot() {
  static const Model model = Model::from_model(load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml"));
  return model;
}

// The long form of a test was asked for.
inline bool long_tests() { return std::getenv("FOOTHOLD_LONG") != nullptr; }

inline double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<>(low, high)(random);
}

// From random lengths of the actuators, so all within the limits.
inline Coordinates random_coordinates(std::mt19937_64& random) {
  const auto& mechanism = robot().mechanism;
  const auto some = [&] {
    return mechanism.forward(
        {uniform(random, mechanism.shortest(), mechanism.longest()), uniform(random, mechanism.shortest(), mechanism.longest())});
  };
  Coordinates out;
  for (Leg& leg : out.leg) {
    const auto ankle = some(), upper = some();
    leg = {ankle.phi, ankle.y, upper.phi, upper.y};
  }
  for (double& hip : out.hip) hip = uniform(random, -std::numbers::pi, std::numbers::pi);
  return out;
}

// The same, with hips that make the soles' Z axes (paper) parallel or antiparallel.
inline Coordinates random_singular_coordinates(std::mt19937_64& random) {
  Coordinates out = random_coordinates(random);
  out.hip[1] = std::remainder(out.hip[0] + (random() % 2 == 0 ? 0.0 : std::numbers::pi), 2.0 * std::numbers::pi);
  return out;
}

// Greatest difference of two poses: metres, or radians.
inline double difference(const Isometry3d& a, const Isometry3d& b) {
  const Eigen::Matrix3d turn = a.linear().transpose() * b.linear();
  const Vector3d axis(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
  const double angle = std::atan2(0.5 * axis.norm(), 0.5 * (turn.trace() - 1.0));
  return std::fmax((a.translation() - b.translation()).norm(), angle);
}

}  // namespace foothold::hyrecro
