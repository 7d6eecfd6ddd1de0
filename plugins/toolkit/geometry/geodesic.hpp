// Shortest ways of a point to a goal among polygons: exact, over the visibility graph of the obstacles' corners.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "geometry/polygon.hpp"

namespace foothold::geometry {

// Immutable; any thread. Building takes (corners)^2 * edges, a query corners * edges in the worst case.
class Geodesic {
 public:
  // Obstacles are open sets: a way may run along their edges, so the distance is a lower bound for everything that has a width.
  // Stopped, it knows fewer ways than there are.
  Geodesic(const Vector2d& goal, const std::vector<Polygon>& obstacles, const std::stop_token& stop = {});
  // m; infinite where no way leads to the goal. Never more than the true distance but for rounding.
  double distance(const Vector2d& point) const;

 private:
  struct Corner {
    Vector2d at;
    double distance;  // to the goal
  };
  bool sees(const Vector2d& from, const Vector2d& to) const;

  Vector2d goal_;
  std::vector<Polygon> obstacles_;
  std::vector<Circle> circles_;
  std::vector<Corner> corners_;  // those from which the goal can be reached, nearest first
};

}  // namespace foothold::geometry
