// How far it is to the goal round the obstacles: a grid of shortest distances for the centre of body A, as guidance for the
// approach.
#pragma once

#include <stop_token>
#include <vector>

#include "surroundings.hpp"

namespace foothold::xrobin {

// Immutable; any thread.
class PathField {
 public:
  // Over a rectangle that holds start, goal and all obstacles. Distances are along the grid's eight directions, so up to 8 % too
  // long.
  // Stopped, it is of no use.
  PathField(const Surroundings& surroundings, const geometry::Vector2d& start, const geometry::Vector2d& goal,
            const std::stop_token& stop);
  // m; infinite where no way leads to the goal; beside the grid the straight distance to it and the way from there.
  double distance(double x, double y) const;

 private:
  geometry::Vector2d goal_;
  geometry::Vector2d corner_;
  double cell_ = 0.01;  // m
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> distance_;
};

}  // namespace foothold::xrobin
