// Random poses of the free sole, by kind, in and around the workspace.
#pragma once

#include "fixtures.hpp"

namespace foothold::hyrecro {

enum class Kind { kPlanar, kAligned, kTransition, kGeneral };
inline constexpr Kind kKinds[] = {Kind::kPlanar, Kind::kAligned, Kind::kTransition, Kind::kGeneral};

inline Isometry3d turned(double angle, const Vector3d& axis) { return Isometry3d(Eigen::AngleAxisd(angle, axis)); }

inline Vector3d in_sphere(std::mt19937_64& random, double radius) {
  Vector3d out;
  do out = {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
  while (out.norm() > 1.0);
  return radius * out;
}

// Planar: in the plane of the foot that holds. Aligned: there with equal or opposite headings, so singular. Transition: the soles'
// Y axes (interface) parallel or antiparallel. Positions uniform in the sphere that the robot cannot leave; of transitions also
// near enough across that only the plane of the legs decides.
inline Isometry3d random_pose(std::mt19937_64& random, Kind kind) {
  Isometry3d out = Isometry3d::Identity();
  const double angle = uniform(random, -std::numbers::pi, std::numbers::pi);
  switch (kind) {
    case Kind::kPlanar:
    case Kind::kAligned:
      do out.translation() = Vector3d(uniform(random, -0.6, 0.6), uniform(random, -0.6, 0.6), 0.0);
      while (out.translation().norm() > 0.6);
      out.linear() = turned(kind == Kind::kPlanar ? angle : (angle < 0.0 ? 0.0 : std::numbers::pi), Vector3d::UnitZ()).linear();
      break;
    case Kind::kTransition:
      out.translation() = in_sphere(random, 0.9);
      if (random() % 2 == 0) out.translation().y() = uniform(random, -0.1, 0.1);
      out.linear() = turned(angle, Vector3d::UnitY()).linear();
      if (random() % 2 == 0) out.linear() = out.linear() * turned(std::numbers::pi, Vector3d::UnitZ()).linear();
      break;
    case Kind::kGeneral:
      out.translation() = in_sphere(random, 0.9);
      out.linear() =
          Eigen::Quaterniond(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1))
              .normalized()
              .toRotationMatrix();
      break;
  }
  return out;
}

// The pose of a random posture: reachable but for what collides.
inline Isometry3d random_reached_pose(std::mt19937_64& random, Kind kind) {
  if (kind == Kind::kGeneral) return forward(robot(), random_coordinates(random));
  if (kind == Kind::kTransition) return forward(robot(), random_singular_coordinates(random));
  const auto& mechanism = robot().mechanism;
  Coordinates c = kind == Kind::kAligned ? random_singular_coordinates(random) : random_coordinates(random);
  const auto upright = [&](double phi, double height) {
    const double y = 0.5 * (height / std::cos(phi) + robot().core);
    return Leg{phi, y, -phi, y};
  };
  do {
    const double height = uniform(random, 0.18, 0.34), most = mechanism.greatest_phi();
    for (Leg& leg : c.leg) leg = upright(uniform(random, -most, most), height);
  } while (!within_limits(robot(), c));
  return forward(robot(), c);
}

}  // namespace foothold::hyrecro
