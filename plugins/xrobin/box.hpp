// Distance of a polygon to a box: the innermost loop of the search among obstacles.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>

#include "planar.hpp"

namespace foothold::xrobin {

// A box |x| <= half_x, |y| <= half_y of a frame, with rounded corners of `radius`. A piston is one without height. m.
struct Box {
  double x = 0.0, y = 0.0;          // of the frame's origin
  double cosine = 1.0, sine = 0.0;  // of its heading
  double half_x = 0.0, half_y = 0.0;
  double radius = 0.0;
};

Box box_at(const PlanarPose& pose, double half_x, double half_y);
Box box_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius);

// From the box to the filled polygon, less the radius; 0 less the radius if they touch. Where it is more than `enough`, a lower
// bound of it that is more than `enough` will do.
double box_distance(const Box& box, std::span<const Eigen::Vector2d> polygon,
                    double enough = std::numeric_limits<double>::infinity());

}  // namespace foothold::xrobin
