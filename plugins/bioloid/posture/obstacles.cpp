// Planes between prisms and boxes; spheres first.
#include "bioloid/posture/obstacles.hpp"

#include <algorithm>

#include "bioloid/posture/inside.hpp"
#include "bioloid/posture/planes.hpp"

namespace foothold::bioloid {
namespace {

using Eigen::Vector2d;

// Between prism and box along n, out of the prism.
double gap_along(const Obstacle& obstacle, const collision::Box& box, const Vector3d& n) {
  double farthest = -1e9;
  for (const Vector3d& corner : obstacle.corners) farthest = std::max(farthest, n.dot(corner));
  return least_along(box, n) - farthest;
}

}  // namespace

Obstacle::Obstacle(const Prism& prism) : height(prism.height), circle(geometry::circle_round(prism.polygon)) {
  const std::size_t count = prism.polygon.size();
  for (const double z : {0.0, prism.height})
    for (const Vector2d& corner : prism.polygon) corners.emplace_back(corner.x(), corner.y(), z);
  faces.emplace_back(corners.begin() + static_cast<std::ptrdiff_t>(count), corners.end());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = (i + 1) % count;
    const Vector2d along = (prism.polygon[j] - prism.polygon[i]).normalized(), outward(along.y(), -along.x());
    sides.push_back({outward, outward.dot(prism.polygon[i])});
    faces.push_back({corners[i], corners[j], corners[count + j], corners[count + i]});
  }
}

bool clear(const Obstacle& obstacle, const Vector3d& a, const Vector3d& b, double needed) {
  if (std::min(a.z(), b.z()) >= obstacle.height + needed) return true;
  const Vector2d from = a.head<2>() - obstacle.circle.centre, to = b.head<2>() - obstacle.circle.centre;
  if (0.5 * ((from + to).norm() - (from - to).norm()) - obstacle.circle.radius >= needed) return true;
  for (const Obstacle::Side& side : obstacle.sides)
    if (std::min(side.outward.dot(a.head<2>()), side.outward.dot(b.head<2>())) - side.offset >= needed) return true;
  return false;
}

bool clear(const Obstacle& obstacle, const collision::Box& box, double clearance) {
  for (const auto& face : obstacle.faces)
    if (collision::nearer(box, collision::Patch{face}, clearance)) return false;
  const Vector3d centre = box.pose.translation();
  if (centre.z() > obstacle.height) return true;
  for (const Obstacle::Side& side : obstacle.sides)
    if (side.outward.dot(centre.head<2>()) > side.offset) return true;
  return false;
}

bool clear(const Obstacle& obstacle, const collision::Box& a, const collision::Box& b, double needed) {
  if (std::min(least_along(a, Vector3d::UnitZ()), least_along(b, Vector3d::UnitZ())) >= obstacle.height + needed) return true;
  const auto parts = [&](const Vector3d& n) { return gap_along(obstacle, a, n) >= needed && gap_along(obstacle, b, n) >= needed; };
  for (const Obstacle::Side& side : obstacle.sides) {
    const Vector3d n(side.outward.x(), side.outward.y(), 0.0);
    if (least_along(a, n) >= side.offset + needed && least_along(b, n) >= side.offset + needed) return true;
  }
  for (const collision::Box* box : {&a, &b})
    for (int k = 0; k < 3; ++k) {
      const Vector3d axis = box->pose.linear().col(k);
      if (parts(axis) || parts(-axis)) return true;
      for (std::size_t i = 0; i <= obstacle.sides.size(); ++i) {
        const Vector3d edge =
            i == 0 ? Vector3d(0, 0, 1) : Vector3d(-obstacle.sides[i - 1].outward.y(), obstacle.sides[i - 1].outward.x(), 0);
        const Vector3d n = axis.cross(edge);
        if (n.squaredNorm() < 1e-8) continue;
        if (parts(n.normalized()) || parts(-n.normalized())) return true;
      }
    }
  return false;
}

void Judge::Inside::stand_near(const Support& support) {
  const Eigen::Vector2d at = support.at.translation().head<2>();
  if (near_at && *near_at == at) return;
  near_at = at;
  near.clear();
  for (const Obstacle& obstacle : obstacles)
    if ((obstacle.circle.centre - at).norm() - obstacle.circle.radius <= reach) near.push_back(&obstacle);
}

bool Judge::Inside::clear_of_obstacles(const Snapshot& a, const Snapshot& b, const Bends* bends) const {
  if (near.empty()) return true;
  const auto seen = [&](const Snapshot& at) {
    Isometry3d out = Isometry3d::Identity();
    out.linear() = ground.support.at.linear() * at.sole_turn.transpose();
    out.translation() = ground.support.at.translation() - out.linear() * at.sole;
    return out;
  };
  const Isometry3d torso_a = seen(a), torso_b = bends ? seen(b) : torso_a;
  const auto round_is_clear = [&](const Vector3d& at_a, const Vector3d& at_b, double radius, double bend) {
    const double needed = radius + demands.clearance + 0.125 * bend;
    return std::all_of(near.begin(), near.end(), [&](const Obstacle* o) { return clear(*o, at_a, at_b, needed); });
  };
  const auto is_clear = [&](const collision::Box& box_a, const collision::Box& box_b, double bend) {
    const double needed = demands.clearance + 0.125 * bend, radius = box_a.half.norm();
    return std::all_of(near.begin(), near.end(), [&](const Obstacle* o) {
      return clear(*o, box_a.pose.translation(), box_b.pose.translation(), radius + needed) || clear(*o, box_a, box_b, needed) ||
             (!bends && clear(*o, box_a, demands.clearance));
    });
  };
  for (std::size_t k = 0; k < kLinks; ++k) {
    const Lanes3 centre_a = centre_of(legs, a.stand, k), centre_b = bends ? centre_of(legs, b.stand, k) : centre_a;
    for (const Side side : {Side::kRight, Side::kLeft}) {
      const double bend = bends ? of(bends->from_sole[k], side) : 0.0;
      if (round_is_clear(torso_a * centre_a.at(side), torso_b * centre_b.at(side), of(legs.boxes[k].radius, side), bend)) continue;
      const Isometry3d at_a = torso_a * frame_of(legs, a.stand, side, k),
                       at_b = bends ? torso_b * frame_of(legs, b.stand, side, k) : at_a;
      for (const BodyBox& box : model.bodies[body_of(side, k)].boxes) {
        const Eigen::Translation3d centre(box.centre);
        if (!is_clear({at_a * centre, box.half}, {at_b * centre, box.half}, bend)) return false;
      }
    }
  }
  const double bend = bends ? bends->upper : 0.0;
  if (round_is_clear(torso_a.translation(), torso_b.translation(), std::max(a.upper->reach, b.upper->reach), bend)) return true;
  for (std::size_t i = 0; i < a.upper->parts.size(); ++i) {
    const collision::Box &box_a = a.upper->parts[i].box, &box_b = b.upper->parts[i].box;
    if (round_is_clear(torso_a * box_a.pose.translation(), torso_b * box_b.pose.translation(), box_a.half.norm(), bend)) continue;
    if (!is_clear({torso_a * box_a.pose, box_a.half}, {torso_b * box_b.pose, box_b.half}, bend)) return false;
  }
  return true;
}

}  // namespace foothold::bioloid
