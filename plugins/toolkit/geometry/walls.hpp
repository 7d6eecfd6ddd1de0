// An obstacle of a plane scene as it is drawn: walls and a roof. A flat outline would be something to stand on.
#pragma once

#include <vector>

#include "foothold/types.hpp"
#include "geometry/plane_scene.hpp"

namespace foothold::geometry {

// From the ground up to `height`, m. Any thread.
std::vector<Shape> walls_of(const Obstacle& obstacle, double height);

}  // namespace foothold::geometry
