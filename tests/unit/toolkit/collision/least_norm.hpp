// The oracle: the distance of two convex hulls as the point of least norm in their Minkowski difference, with a certificate.
#pragma once

#include <vector>

#include "collision/distance.hpp"

namespace foothold::collision {

using Points = std::vector<Vector3d>;

Points points_of(const Capsule& capsule);  // of its axis
Points points_of(const Box& box);
Points points_of(const Patch& patch);

// The distance of the hulls lies in [low, high]: `high` is that of two points in them, `low` the gap along a direction.
struct Bracket {
  double low = 0.0, high = 0.0;
};
Bracket hull_distance(const Points& a, const Points& b);

}  // namespace foothold::collision
