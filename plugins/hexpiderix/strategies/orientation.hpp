// Roll, pitch and yaw of the thorax as the paper takes them (eq. 1: about X, Y and Z, in this order from the inside). Radians.
#pragma once

#include <cmath>

#include "foothold/types.hpp"

namespace foothold::hexpiderix {

struct Orientation {
  double roll = 0.0, pitch = 0.0, yaw = 0.0;
};

inline Orientation orientation_of(const Isometry3d& pose) {
  const Eigen::Matrix3d& r = pose.linear();
  return {std::atan2(r(2, 1), r(2, 2)), std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0))), std::atan2(r(1, 0), r(0, 0))};
}

// The pose at the same place with another orientation.
inline Isometry3d turned(const Isometry3d& pose, const Orientation& to) {
  Isometry3d out = pose;
  out.linear() = (Eigen::AngleAxisd(to.yaw, Vector3d::UnitZ()) * Eigen::AngleAxisd(to.pitch, Vector3d::UnitY()) *
                  Eigen::AngleAxisd(to.roll, Vector3d::UnitX()))
                     .toRotationMatrix();
  return out;
}

}  // namespace foothold::hexpiderix
