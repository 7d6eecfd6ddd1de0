// Footprints against the polygons of obstacles.
#include "bioloid/steps/footing.hpp"

#include <algorithm>

#include "contact/support_polygon.hpp"

namespace foothold::bioloid {
namespace {

geometry::Polygon hull(const geometry::Polygon& a, const geometry::Polygon& b) {
  std::vector<Vector3d> points;
  for (const auto* polygon : {&a, &b})
    for (const geometry::Vector2d& point : *polygon) points.emplace_back(point.x(), point.y(), 0.0);
  geometry::Polygon out;
  for (const Vector3d& corner : contact::support_polygon(points)) out.emplace_back(corner.head<2>());
  return out;
}

// True if no sole within `reach` of a place comes near the prism.
bool far(const Prism& prism, const PlanarPose& sole, double reach) {
  const geometry::Circle round = geometry::circle_round(prism.polygon);
  return (round.centre - Eigen::Vector2d(sole.x, sole.y)).norm() > round.radius + reach;
}

double radius(const Model& model) { return 0.5 * std::hypot(model.sole_length, model.sole_width); }

}  // namespace

geometry::Polygon footprint(const Model& model, const PlanarPose& sole, double margin) {
  const double length = 0.5 * model.sole_length + margin, width = 0.5 * model.sole_width + margin;
  geometry::Polygon out;
  for (const auto& [x, y] : {std::pair{length, -width}, {length, width}, {-length, width}, {-length, -width}}) {
    const PlanarPose corner = sole * PlanarPose{x, y, 0.0};
    out.emplace_back(corner.x, corner.y);
  }
  return out;
}

const Prism* stands_on(const Model& model, const PlanarPose& sole, std::span<const Prism> prisms, double clearance) {
  const geometry::Polygon print = footprint(model, sole, 0.0);
  for (const Prism& prism : prisms)
    if (!far(prism, sole, radius(model) + clearance) && geometry::distance(print, prism.polygon) < clearance) return &prism;
  return nullptr;
}

double highest_between(const Model& model, const PlanarPose& from, const PlanarPose& to, std::span<const Prism> prisms,
                       double clearance) {
  const double reach = radius(model) + clearance + distance(from, to);
  double height = 0.0;
  geometry::Polygon swept;
  for (const Prism& prism : prisms) {
    if (prism.height <= height || far(prism, from, reach)) continue;
    if (swept.empty()) swept = hull(footprint(model, from, 0.0), footprint(model, to, 0.0));
    if (geometry::distance(swept, prism.polygon) < clearance) height = prism.height;
  }
  return height;
}

}  // namespace foothold::bioloid
