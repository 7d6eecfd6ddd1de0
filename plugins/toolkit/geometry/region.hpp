// Plane regions with holes: what remains of one when parts are cut out of it, and the part that keeps away from its edges.
//
// Library polyclipping inside, on a grid of 1e-8 m; what nothing is cut out of keeps its vertices exactly. Metres; free functions
// of values; any thread.
#pragma once

#include <span>
#include <vector>

#include "geometry/polygon.hpp"

namespace foothold::geometry {

struct Region {
  Polygon outline;             // simple, counter-clockwise
  std::vector<Polygon> holes;  // clockwise, inside the outline
};

double area(const Region& region);  // m^2
// On an edge: either.
bool contains(const Region& region, const Vector2d& point);

// `region` without the filled `cutters` (simple, any direction, they may overlap). In pieces, each at least 1e-10 m^2.
std::vector<Region> difference(const Region& region, std::span<const Polygon> cutters);

// The points at least `distance` (m, >= 0) away from every edge's line on its inner side: edges move in parallel, corners are
// mitred exactly up to a sharpness of 1:20 (2.9 deg; sharper ones are cut off square, which keeps away no less). In pieces.
std::vector<Region> inset(const Region& region, double distance);

}  // namespace foothold::geometry
