// Rodrigues' formula for a line in space, and its product along a chain.
#include "kinematics/screw.hpp"

#include <cassert>
#include <cmath>

namespace foothold::kinematics {

Eigen::Isometry3d displacement(const Screw& screw, double angle, double slide) {
  const Eigen::Vector3d& s = screw.axis;
  const double cosine = std::cos(angle), sine = std::sin(angle), versine = 1.0 - cosine;
  Eigen::Matrix3d turn;
  turn << (s.x() * s.x() - 1) * versine + 1, s.x() * s.y() * versine - s.z() * sine, s.x() * s.z() * versine + s.y() * sine,
      s.y() * s.x() * versine + s.z() * sine, (s.y() * s.y() - 1) * versine + 1, s.y() * s.z() * versine - s.x() * sine,
      s.z() * s.x() * versine - s.y() * sine, s.z() * s.y() * versine + s.x() * sine, (s.z() * s.z() - 1) * versine + 1;
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  out.linear() = turn;
  out.translation() = slide * s + screw.point - turn * screw.point;
  return out;
}

Eigen::Isometry3d closure(std::span<const Screw> screws, std::span<const double> angles) {
  assert(screws.size() == angles.size());
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < screws.size(); ++i) out = out * displacement(screws[i], angles[i]);
  return out;
}

}  // namespace foothold::kinematics
