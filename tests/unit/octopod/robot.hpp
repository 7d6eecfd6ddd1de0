// The octopod of the tests, and random postures of it.
#pragma once

#include <numbers>
#include <random>

#include "foothold/robot_file.hpp"
#include "octopod/model/body.hpp"

namespace foothold::octopod {

inline const Model& octopod() {
  static const Model model = Model::from_model(load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/octopod.yaml"));
  return model;
}

inline double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline Vector3d random_vector(std::mt19937_64& random, double size) {
  return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

inline Eigen::Quaterniond random_rotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
}

inline Coordinates random_coordinates(std::mt19937_64& random) {
  Coordinates out;
  out.front.translation() = random_vector(random, 1.0);
  out.front.linear() = random_rotation(random).toRotationMatrix();
  out.ball = random_rotation(random);
  for (Vector3d& joints : out.legs) joints = random_vector(random, std::numbers::pi);
  return out;
}

}  // namespace foothold::octopod
