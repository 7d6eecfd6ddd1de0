// A stance: point contacts with dry friction, under gravity along -Z. Metres, world frame; plain values, any thread.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <utility>

namespace foothold::contact {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;

// Standard gravity, m/s^2, along -Z. What this library calls a force is in units of the robot's weight, so mass and gravity only
// matter to who wants newtons: f [N] = f * mass * kGravity.
constexpr double kGravity = 9.80665;

// A point at which the robot can push against the world, and the world's unit normal there, out of the surface: towards the robot.
struct Contact {
  Vector3d point = Vector3d::Zero();
  Vector3d normal = Vector3d::UnitZ();
};

// Coulomb's cone |f_t| <= mu f_n, or the pyramid inscribed in it whose edges touch it at angles 2 pi j / edges from the first
// tangent towards the second (see tangents()).
struct FrictionCone {
  int edges = 0;  // 0: the cone itself; else 3 or more

  static constexpr FrictionCone circular() { return {0}; }
  static constexpr FrictionCone pyramid(int edges) { return {edges}; }
};

// Two unit tangents that make a right-handed frame with the unit normal: (t, b, n). They depend on the normal alone, and not
// continuously across n_z = 0. Duff et al. 2017, "Building an orthonormal basis, revisited", J. Computer Graphics Techniques 6(1).
inline std::pair<Vector3d, Vector3d> tangents(const Vector3d& n) {
  const double sign = n.z() < 0.0 ? -1.0 : 1.0, a = -1.0 / (sign + n.z()), b = n.x() * n.y() * a;
  return {{1.0 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()}, {b, sign + n.y() * n.y() * a, -n.y()}};
}

}  // namespace foothold::contact
