// What the robot stands on and what stands beside it, seen from the support sole's frame. Private to posture/.
#pragma once

#include <vector>

#include "bioloid/posture/judge.hpp"
#include "collision/distance.hpp"
#include "contact/support_polygon.hpp"

namespace foothold::bioloid {

struct Ground {
  Ground() = default;
  Ground(const Model& model, const Support& support, std::span<const Prism> obstacles, double reach);

  struct Edge {
    Eigen::Vector2d inward;
    double offset;  // a point lies inside by inward . p - offset
  };
  // A prism within reach.
  struct Obstacle {
    double height = 0.0;
    geometry::Circle circle;
    std::vector<Vector3d> corners;             // lower, then upper ones
    std::vector<Edge> sides;                   // `inward`: out of the prism
    std::vector<std::vector<Vector3d>> faces;  // top, then sides
  };
  Support support;
  contact::SupportPolygon polygon;
  std::vector<Edge> edges;  // of the support polygon
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  std::vector<Obstacle> obstacles;
  double highest = 0.0;  // of the obstacles

  bool is_for(const Support& other) const;
};

// True if the box stands clear of the prism by `clearance`; exact.
bool clear(const Ground::Obstacle& obstacle, const collision::Box& box, double clearance);
// True if one plane, fixed in the support's frame, leaves `needed` between them both at a and at b.
bool clear(const Ground::Obstacle& obstacle, const collision::Box& a, const collision::Box& b, double needed);

}  // namespace foothold::bioloid
