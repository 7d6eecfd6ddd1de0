// The X axis of a face that brings none along.
#include "geometry/axis.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace foothold::geometry {

// World X pressed into the plane, or world Y where X is (nearly) the normal.
Eigen::Vector3d axis_in(const Eigen::Vector3d& normal) {
  const Eigen::Vector3d along = std::abs(normal.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  return (along - along.dot(normal) * normal).normalized();
}

}  // namespace foothold::geometry
