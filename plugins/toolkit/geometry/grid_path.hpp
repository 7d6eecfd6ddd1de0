// A* over the points of a square grid inside a polygon: the continuous way of Zhu et al. (IEEE/ASME Transactions on Mechatronics
// 26:2712, 2020), as a baseline for PolygonPaths.
#pragma once

#include <vector>

#include "geometry/polygon_path.hpp"

namespace foothold::geometry {

enum class GridNeighbours { kFour, kEight };

// The grid has a point at `from` and is parallel to the axes; `step` in metres. Neighbours are linked where the straight way
// between them stays inside; `to` is linked to the grid points around it (nearer than one step along both axes). Empty if there is
// no such way. Any thread.
std::vector<Vector2d> grid_path(const PolygonPaths& inside, const Vector2d& from, const Vector2d& to, double step,
                                GridNeighbours neighbours = GridNeighbours::kEight);

double length_of(const std::vector<Vector2d>& path);  // m

}  // namespace foothold::geometry
