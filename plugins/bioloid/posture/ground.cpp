// Support polygon and prisms; separating planes between a box and a prism.
#include "bioloid/posture/ground.hpp"

#include <algorithm>

#include "bioloid/posture/planes.hpp"

namespace foothold::bioloid {
namespace {

using Eigen::Vector2d;

bool same(const Isometry3d& a, const Isometry3d& b) { return a.matrix().topRows<3>() == b.matrix().topRows<3>(); }

Ground::Obstacle seen_from(const Isometry3d& world, const Prism& prism) {
  Ground::Obstacle out;
  const std::size_t count = prism.polygon.size();
  geometry::Polygon polygon;
  for (const double z : {0.0, prism.height})
    for (const Vector2d& corner : prism.polygon) out.corners.push_back(world * Vector3d(corner.x(), corner.y(), z));
  for (std::size_t i = 0; i < count; ++i) polygon.push_back(out.corners[i].head<2>());
  out.height = out.corners.back().z();
  out.circle = geometry::circle_round(polygon);
  out.faces.emplace_back(out.corners.begin() + static_cast<std::ptrdiff_t>(count), out.corners.end());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = (i + 1) % count;
    const Vector2d along = (polygon[j] - polygon[i]).normalized(), outward(along.y(), -along.x());
    out.sides.push_back({outward, outward.dot(polygon[i])});
    out.faces.push_back({out.corners[i], out.corners[j], out.corners[count + j], out.corners[count + i]});
  }
  return out;
}

// Between prism and box along n, out of the prism.
double gap_along(const Ground::Obstacle& obstacle, const collision::Box& box, const Vector3d& n) {
  double farthest = -1e9;
  for (const Vector3d& corner : obstacle.corners) farthest = std::max(farthest, n.dot(corner));
  return least_along(box, n) - farthest;
}

}  // namespace

Ground::Ground(const Model& model, const Support& on, std::span<const Prism> prisms, double reach) : support(on) {
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
  const Isometry3d from_world = on.at.inverse();
  for (const Prism& prism : prisms) {
    Obstacle seen = seen_from(from_world, prism);
    if (seen.circle.centre.norm() - seen.circle.radius > reach) continue;
    highest = std::max(highest, seen.height);
    obstacles.push_back(std::move(seen));
  }
}

bool Ground::is_for(const Support& other) const {
  return !edges.empty() && support.foot == other.foot && support.both == other.both && same(support.at, other.at) &&
         (!other.both || same(support.second, other.second));
}

bool clear(const Ground::Obstacle& obstacle, const collision::Box& box, double clearance) {
  for (const auto& face : obstacle.faces)
    if (collision::nearer(box, collision::Patch{face}, clearance)) return false;
  const Vector3d centre = box.pose.translation();
  if (centre.z() > obstacle.height) return true;
  for (const Ground::Edge& side : obstacle.sides)
    if (side.inward.dot(centre.head<2>()) > side.offset) return true;
  return false;
}

bool clear(const Ground::Obstacle& obstacle, const collision::Box& a, const collision::Box& b, double needed) {
  if (std::min(least_along(a, Vector3d::UnitZ()), least_along(b, Vector3d::UnitZ())) >= obstacle.height + needed) return true;
  const auto parts = [&](const Vector3d& n) { return gap_along(obstacle, a, n) >= needed && gap_along(obstacle, b, n) >= needed; };
  for (const Ground::Edge& side : obstacle.sides) {
    const Vector3d n(side.inward.x(), side.inward.y(), 0.0);
    if (least_along(a, n) >= side.offset + needed && least_along(b, n) >= side.offset + needed) return true;
  }
  for (const collision::Box* box : {&a, &b})
    for (int k = 0; k < 3; ++k) {
      const Vector3d axis = box->pose.linear().col(k);
      if (parts(axis) || parts(-axis)) return true;
      for (std::size_t i = 0; i <= obstacle.sides.size(); ++i) {
        const Vector3d edge =
            i == 0 ? Vector3d(0, 0, 1) : Vector3d(-obstacle.sides[i - 1].inward.y(), obstacle.sides[i - 1].inward.x(), 0);
        const Vector3d n = axis.cross(edge);
        if (n.squaredNorm() < 1e-8) continue;
        if (parts(n.normalized()) || parts(-n.normalized())) return true;
      }
    }
  return false;
}

}  // namespace foothold::bioloid
