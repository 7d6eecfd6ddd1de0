// The plane in which a leg moves, in the paper's frames: X forward, Y out of the surface, Z along the mechanisms' axes.
//
// Where the hip can be, seen from the sole: hip = (0, a) + lambda n(phi1) + a2 n(psi), n(x) = (-sin x, cos x). Values; any thread.
#pragma once

#include <cmath>

#include "hyrecro/model/chain.hpp"

namespace foothold::hyrecro {

using Eigen::Matrix3d;
using Eigen::Vector2d;

// A pose of the interface (X forward, Z out of the surface) in the paper's frames.
struct PaperPose {
  Matrix3d r;
  Vector3d p;

  explicit PaperPose(const Isometry3d& wire) {
    constexpr int axis[3] = {0, 2, 1};
    constexpr double sign[3] = {1.0, 1.0, -1.0};
    for (int i = 0; i < 3; ++i) {
      p[i] = sign[i] * wire.translation()[axis[i]];
      for (int j = 0; j < 3; ++j) r(i, j) = sign[i] * sign[j] * wire.linear()(axis[i], axis[j]);
    }
  }
};

inline Vector2d normal_at(double angle) { return {-std::sin(angle), std::cos(angle)}; }

// Middle of the hip plate's end of a leg.
inline Vector2d hip_of_leg(const Model& model, double phi1, double lambda, double psi) {
  return Vector2d(0.0, model.ankle_height) + lambda * normal_at(phi1) + model.hip_drop * normal_at(psi);
}

}  // namespace foothold::hyrecro
