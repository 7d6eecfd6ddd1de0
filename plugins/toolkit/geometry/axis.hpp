// The X axis that a plane is given when nothing else tells it.
#pragma once

#include <Eigen/Core>

namespace foothold::geometry {

// A unit vector that is perpendicular to `normal` (not zero) and depends on it alone. Any thread.
Eigen::Vector3d axis_in(const Eigen::Vector3d& normal);

}  // namespace foothold::geometry
