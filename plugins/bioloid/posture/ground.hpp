// What the robot stands on, seen from the support sole's frame. Private to posture/.
#pragma once

#include <vector>

#include "bioloid/posture/judge.hpp"
#include "contact/support_polygon.hpp"

namespace foothold::bioloid {

struct Ground {
  Ground() = default;
  Ground(const Model& model, const Support& support);

  struct Edge {
    Eigen::Vector2d inward;
    double offset;  // a point lies inside by inward . p - offset
  };
  Support support;
  contact::SupportPolygon polygon;
  std::vector<Edge> edges;  // of the support polygon
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();

  bool is_for(const Support& other) const;
};

}  // namespace foothold::bioloid
