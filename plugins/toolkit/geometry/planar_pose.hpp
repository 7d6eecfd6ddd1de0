// Poses in a plane: x, y in metres, heading in radians about the plane's normal. Values; any thread.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace foothold::geometry {

struct PlanarPose {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
};

// a after which b is taken in a's frame.
inline PlanarPose operator*(const PlanarPose& a, const PlanarPose& b) {
  const double c = std::cos(a.heading);
  const double s = std::sin(a.heading);
  return {a.x + c * b.x - s * b.y, a.y + s * b.x + c * b.y, a.heading + b.heading};
}

inline PlanarPose inverse(const PlanarPose& a) {
  const double c = std::cos(a.heading);
  const double s = std::sin(a.heading);
  return {-c * a.x - s * a.y, s * a.x - c * a.y, -a.heading};
}

// `b` as `a` sees it.
inline PlanarPose relative(const PlanarPose& a, const PlanarPose& b) { return inverse(a) * b; }

// The angle of the same direction in (-pi, pi].
inline double wrapped(double angle) {
  const double turns = std::ceil((angle - std::numbers::pi) / (2.0 * std::numbers::pi));
  return angle - turns * 2.0 * std::numbers::pi;
}

inline double distance(const PlanarPose& a, const PlanarPose& b) { return std::hypot(a.x - b.x, a.y - b.y); }

// In the world, in the plane of height z (m).
inline Eigen::Isometry3d to_world(const PlanarPose& pose, double z = 0.0) {
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  out.translate(Eigen::Vector3d(pose.x, pose.y, z));
  out.rotate(Eigen::AngleAxisd(pose.heading, Eigen::Vector3d::UnitZ()));
  return out;
}

}  // namespace foothold::geometry
