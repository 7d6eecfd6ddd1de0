// Poses in the robot's plane.
#pragma once

#include "geometry/planar_pose.hpp"

namespace foothold::xrobin {

using geometry::distance;
using geometry::inverse;
using geometry::PlanarPose;
using geometry::to_world;
using geometry::wrapped;

}  // namespace foothold::xrobin
