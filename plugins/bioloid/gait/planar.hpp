// A sole's place on flat ground: position and heading.
#pragma once

#include "geometry/planar_pose.hpp"

namespace foothold::bioloid {

using geometry::distance;
using geometry::inverse;
using geometry::PlanarPose;
using geometry::relative;
using geometry::to_world;
using geometry::wrapped;

}  // namespace foothold::bioloid
