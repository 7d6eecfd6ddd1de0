// Inside of the collision library: the distances of segments and points that every pair of bodies comes down to. Squared, m^2.
#pragma once

#include <array>
#include <utility>

#include "collision/distance.hpp"

namespace foothold::collision {

// Between two segments.
double squared_of_segments(const Vector3d& a0, const Vector3d& a1, const Vector3d& b0, const Vector3d& b1);

// Between a point and the box [-half, half].
inline double squared_to_box(const Vector3d& point, const Vector3d& half) {
  return (point.cwiseAbs() - half).cwiseMax(0.0).squaredNorm();
}

// Not more than the distance between the segment p-q and the box [-half, half]: along each axis by itself.
inline double squared_bound(const Vector3d& p, const Vector3d& q, const Vector3d& half) {
  return (p.cwiseMin(q) - half).cwiseMax(-half - p.cwiseMax(q)).cwiseMax(0.0).squaredNorm();
}

// Between the segment p-q and the box [-half, half]. The squared distance of p + t (q - p) is convex in t and its slope piecewise
// linear with a bend wherever the segment crosses a face's plane: the slope's zero is bracketed by the bends, then interpolated.
double squared_to_box(const Vector3d& p, const Vector3d& q, const Vector3d& half);

// Corners of a box by the bits of the index, and its edges as pairs of corners.
std::array<Vector3d, 8> corners_of(const Vector3d& centre, const Vector3d& x, const Vector3d& y, const Vector3d& z);
inline constexpr std::array<std::pair<std::size_t, std::size_t>, 12> kEdges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

}  // namespace foothold::collision
