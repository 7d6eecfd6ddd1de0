// Capsules against each other and against boxes: the distance of the axis, less the radius.
#include <algorithm>
#include <cmath>

#include "collision/segments.hpp"

namespace foothold::collision {
namespace {

// The axis in the box's frame.
std::pair<Vector3d, Vector3d> seen_from(const Box& box, const Capsule& capsule) {
  const auto rotation = box.pose.linear().transpose();
  const Vector3d centre = box.pose.translation();
  return {rotation * (capsule.a - centre), rotation * (capsule.b - centre)};
}

}  // namespace

double distance(const Capsule& a, const Capsule& b) {
  return std::max(0.0, std::sqrt(squared_of_segments(a.a, a.b, b.a, b.b)) - a.radius - b.radius);
}

bool nearer(const Capsule& a, const Capsule& b, double clearance) {
  const double sum = a.radius + b.radius + clearance;
  return squared_of_segments(a.a, a.b, b.a, b.b) < sum * sum;
}

double distance(const Capsule& a, const Box& b) {
  const auto [p, q] = seen_from(b, a);
  return std::max(0.0, std::sqrt(squared_to_box(p, q, b.half)) - a.radius);
}

bool nearer(const Capsule& a, const Box& b, double clearance) {
  const auto [p, q] = seen_from(b, a);
  const double sum = a.radius + clearance, limit = sum * sum;
  return squared_bound(p, q, b.half) < limit && squared_to_box(p, q, b.half) < limit;
}

}  // namespace foothold::collision
