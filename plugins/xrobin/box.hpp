// Distance of a polygon to a box in the box's own frame: the innermost loop of the search among obstacles.
#pragma once

#include <Eigen/Core>
#include <span>

namespace foothold::xrobin {

// From the box |x| <= half_x, |y| <= half_y to the filled polygon; 0 if they touch. m.
double box_distance(double half_x, double half_y, std::span<const Eigen::Vector2d> polygon);

}  // namespace foothold::xrobin
