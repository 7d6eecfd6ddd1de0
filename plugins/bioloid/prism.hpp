// What stands on the ground, as search and judge see it.
#pragma once

#include <string>

#include "geometry/polygon.hpp"

namespace foothold::bioloid {

// A prism over a convex polygon, from the ground up, in the world.
struct Prism {
  std::string name;
  geometry::Polygon polygon;  // convex, counter-clockwise, m
  double height = 0.0;        // m
};

}  // namespace foothold::bioloid
