// Prisms as planes to keep boxes from: in the world, made once. Private to posture/.
#pragma once

#include <vector>

#include "bioloid/prism.hpp"
#include "collision/distance.hpp"

namespace foothold::bioloid {

struct Obstacle {
  explicit Obstacle(const Prism& prism);

  struct Side {
    Eigen::Vector2d outward;
    double offset;  // a point lies outside by outward . p - offset
  };
  double height = 0.0;
  geometry::Circle circle;
  std::vector<Side> sides;
  std::vector<Eigen::Vector3d> corners;             // lower, then upper ones
  std::vector<std::vector<Eigen::Vector3d>> faces;  // top, then sides
};

// Each of these is about what moves from a to b, fixed in place if both are the same.

// True if one of the planes round the prism, or of a circle round it, keeps both points `needed` away. Not necessary.
bool clear(const Obstacle& obstacle, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double needed);
// True if the box stands clear of the prism by `clearance`; exact.
bool clear(const Obstacle& obstacle, const collision::Box& box, double clearance);
// True if one plane leaves `needed` between them both at a and at b.
bool clear(const Obstacle& obstacle, const collision::Box& a, const collision::Box& b, double needed);

}  // namespace foothold::bioloid
