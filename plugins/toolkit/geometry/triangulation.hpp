// Simple polygons to triangles and convex pieces.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/polygon.hpp"

namespace foothold::geometry {

// Of a simple counter-clockwise polygon, by ear clipping: triangles by the indices of their corners; convex pieces (itself if it is
// convex, else those triangles). Any thread.
std::vector<std::array<std::size_t, 3>> triangulated(const Polygon& polygon);
std::vector<Polygon> convex_pieces(const Polygon& polygon);

}  // namespace foothold::geometry
