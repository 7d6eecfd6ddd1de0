// Scenes, footholds on them, and an independent look at routes.
#pragma once

#include <gtest/gtest.h>

#include "fixtures.hpp"
#include "hyrecro/optimal/optimal.hpp"

namespace foothold::hyrecro {

inline constexpr double kClearance = 0.005;

inline std::unique_ptr<PreparedTruss> prepared(truss::Truss truss, bool both_headings = true) {
  SamplingOptions options;
  options.both_headings = both_headings;
  return std::make_unique<PreparedTruss>(robot(), std::move(truss), options, kClearance);
}

inline truss::Truss crossed_beams() { return truss::read_truss(FOOTHOLD_CONFIG_DIR "/scenes/truss-crossed-beams.yaml"); }

// In degrees, roll, pitch and yaw as requests give them.
inline Foothold foothold_on(const truss::Truss& truss, const Vector3d& place, const Vector3d& turn) {
  const Vector3d angles = turn * std::numbers::pi / 180.0;
  Isometry3d pose(Eigen::Translation3d(place) * Eigen::AngleAxisd(angles.z(), Vector3d::UnitZ()) *
                  Eigen::AngleAxisd(angles.y(), Vector3d::UnitY()) * Eigen::AngleAxisd(angles.x(), Vector3d::UnitX()));
  return foothold_at(truss, pose, 1e-4).value();
}

// Every stride from forward kinematics alone.
inline void expect_climbable(const PreparedTruss& scene, const Route& route) {
  Foothold holds = route.start;
  for (std::size_t k = 0; k < route.strides.size(); ++k) {
    const Stride& stride = route.strides[k];
    const Isometry3d sole = pose_of(scene.truss, holds), wanted = sole.inverse() * pose_of(scene.truss, stride.to);
    EXPECT_LT(difference(forward(robot(), stride.coordinates), wanted), 1e-6) << "stride " << k;
    EXPECT_TRUE(within_limits(robot(), stride.coordinates, 1e-9)) << "stride " << k;
    const Bodies bodies = bodies_at(robot(), stride.coordinates, sole);
    EXPECT_TRUE(free_of_itself(bodies, kClearance)) << "stride " << k;
    EXPECT_TRUE(scene.obstacles.free(bodies, kClearance)) << "stride " << k;
    EXPECT_TRUE(plate_on_face(robot(), scene.truss.faces[static_cast<std::size_t>(stride.to.face)], stride.to)) << "stride " << k;
    holds = stride.to;
  }
}

inline double length_of(const PreparedTruss& scene, const Route& route) {
  double out = 0.0;
  Vector3d before = pose_of(scene.truss, route.start).translation();
  for (const Stride& stride : route.strides) {
    const Vector3d at = pose_of(scene.truss, stride.to).translation();
    out += (at - before).norm();
    before = at;
  }
  return out;
}

}  // namespace foothold::hyrecro
