// Shortest ways in polygons as CGAL's exact numbers give them, and its random polygons.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/polygon.hpp"

namespace foothold::test {

// By Dijkstra over all vertices and both ends; a pair is linked if every part into which the edges cut its segment has its middle
// inside, all in exact arithmetic. Infinite if there is no way. Precondition: both ends are inside or on the boundary.
double exact_length(const geometry::Polygon& outline, const std::vector<geometry::Polygon>& holes, const geometry::Vector2d& from,
                    const geometry::Vector2d& to);
// Inside or on the boundary, exactly.
bool exactly_inside(const geometry::Polygon& outline, const std::vector<geometry::Polygon>& holes, const geometry::Vector2d& point);

// A simple counter-clockwise polygon of at most `vertices` vertices in the unit square, on multiples of 2^-10 (so that the middles
// of its edges are exact as well).
geometry::Polygon random_polygon(std::uint32_t seed, std::size_t vertices);

}  // namespace foothold::test
