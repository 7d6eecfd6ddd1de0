// Support polygons.
#include "bioloid/posture/ground.hpp"

namespace foothold::bioloid {
namespace {

using Eigen::Vector2d;

bool same(const Isometry3d& a, const Isometry3d& b) { return a.matrix().topRows<3>() == b.matrix().topRows<3>(); }

}  // namespace

Ground::Ground(const Model& model, const Support& on) : support(on) {
  const double l = 0.5 * model.sole_length, w = 0.5 * model.sole_width;
  std::vector<Vector3d> contacts;
  for (const auto& [x, y] : {std::pair(l, w), std::pair(l, -w), std::pair(-l, w), std::pair(-l, -w)}) {
    contacts.emplace_back(x, y, 0.0);
    if (on.both) contacts.push_back(on.second * Vector3d(x, y, 0.0));
  }
  polygon = contact::support_polygon(contacts);
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vector2d from = polygon.corners[i].head<2>(),
                   along = (polygon.corners[(i + 1) % polygon.count].head<2>() - from).normalized();
    const Vector2d inward(-along.y(), along.x());
    edges.push_back({inward, inward.dot(from)});
  }
  if (on.both) middle = 0.5 * on.second.translation().head<2>();
}

bool Ground::is_for(const Support& other) const {
  return !edges.empty() && support.foot == other.foot && support.both == other.both && same(support.at, other.at) &&
         (!other.both || same(support.second, other.second));
}

}  // namespace foothold::bioloid
