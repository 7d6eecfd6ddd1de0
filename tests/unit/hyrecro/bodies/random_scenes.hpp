// Random scenes of boxes and polygons and random postures for the tests of bodies.
#pragma once

#include <random>

#include "foothold/robot_file.hpp"
#include "hyrecro/model/bodies.hpp"

namespace foothold::hyrecro {

inline Model shipped_model() { return Model::from_model(load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml")); }

class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed) {}
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  Isometry3d pose(double extent) {
    Isometry3d out = Isometry3d::Identity();
    out.translate(Vector3d(uniform(-extent, extent), uniform(-extent, extent), uniform(-extent, extent)));
    out.rotate(Eigen::Quaterniond(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized());
    return out;
  }

  // Every actuator anywhere between its limits.
  Coordinates coordinates(const Model& model) {
    const auto length = [&] { return uniform(model.mechanism.shortest(), model.mechanism.longest()); };
    std::vector<double> joints;
    for (int k = 0; k < 8; ++k) joints.push_back(length());
    joints.push_back(uniform(-3.1, 3.1));
    joints.push_back(uniform(-3.1, 3.1));
    return from_joints(model, joints, Foot::kA);
  }

  // Bars at any angle, and triangles.
  truss::Truss scene(int solids, double extent) {
    truss::Truss out;
    for (int k = 0; k < solids; ++k) {
      truss::Solid solid;
      solid.pose = pose(extent);
      if (k % 3 == 2) {
        solid.kind = truss::Solid::Kind::kPolygon;
        solid.polygon = {{0.0, 0.0}, {uniform(0.1, 0.5), 0.0}, {uniform(-0.1, 0.3), uniform(0.1, 0.5)}};
      } else {
        solid.half = {uniform(0.1, 0.8), uniform(0.02, 0.1), uniform(0.02, 0.1)};
      }
      out.solids.push_back(solid);
    }
    return out;
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace foothold::hyrecro
