// First the bounding box of the polygon in the box's frame, then edge by edge: clipping tells crossings, corners and ends give the
// distance.
#include "box.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::xrobin {
namespace {

using Eigen::Vector2d;

Vector2d into_frame(const Box& box, const Vector2d& p) {
  const double dx = p.x() - box.x;
  const double dy = p.y() - box.y;
  return {box.cosine * dx + box.sine * dy, box.cosine * dy - box.sine * dx};
}

// At least so far is the polygon from the box.
double bounding_distance(const Box& box, std::span<const Vector2d> polygon) {
  double left = std::numeric_limits<double>::infinity(), right = -left, bottom = left, top = -left;
  for (const Vector2d& vertex : polygon) {
    const Vector2d v = into_frame(box, vertex);
    left = std::min(left, v.x()), right = std::max(right, v.x());
    bottom = std::min(bottom, v.y()), top = std::max(top, v.y());
  }
  const double dx = std::max({0.0, left - box.half_x, -box.half_x - right});
  const double dy = std::max({0.0, bottom - box.half_y, -box.half_y - top});
  return dx == 0.0 ? dy : dy == 0.0 ? dx : std::sqrt(dx * dx + dy * dy);
}

double square_to_box(const Box& box, const Vector2d& p) {
  const double dx = std::max(0.0, std::abs(p.x()) - box.half_x);
  const double dy = std::max(0.0, std::abs(p.y()) - box.half_y);
  return dx * dx + dy * dy;
}

// Liang and Barsky: whether a part of the segment is inside the box.
bool crosses(const Box& box, const Vector2d& a, const Vector2d& d) {
  double from = 0.0;
  double to = 1.0;
  const auto clip = [&](double position, double step, double half) {
    if (step == 0.0) return std::abs(position) <= half;
    double enter = (-half - position) / step;
    double leave = (half - position) / step;
    if (enter > leave) std::swap(enter, leave);
    from = std::max(from, enter);
    to = std::min(to, leave);
    return from <= to;
  };
  return clip(a.x(), d.x(), box.half_x) && clip(a.y(), d.y(), box.half_y);
}

}  // namespace

Box box_at(const PlanarPose& pose, double half_x, double half_y) {
  return {pose.x, pose.y, std::cos(pose.heading), std::sin(pose.heading), half_x, half_y, 0.0};
}

Box box_between(const Vector2d& from, const Vector2d& to, double radius) {
  const Vector2d middle = 0.5 * (from + to);
  const Vector2d along = to - from;
  const double length = along.norm();
  if (length == 0.0) return {middle.x(), middle.y(), 1.0, 0.0, 0.0, 0.0, radius};
  return {middle.x(), middle.y(), along.x() / length, along.y() / length, 0.5 * length, 0.0, radius};
}

double box_distance(const Box& box, std::span<const Vector2d> polygon, double enough) {
  if (const double bound = bounding_distance(box, polygon) - box.radius; bound > enough) return bound;
  double least = std::numeric_limits<double>::infinity();
  bool holds_centre = false;
  Vector2d a = into_frame(box, polygon.back());
  for (const Vector2d& vertex : polygon) {
    const Vector2d b = into_frame(box, vertex);
    const Vector2d d = b - a;
    if (crosses(box, a, d)) return -box.radius;
    if ((a.y() > 0.0) != (b.y() > 0.0) && a.x() - a.y() / d.y() * d.x() > 0.0) holds_centre = !holds_centre;
    least = std::min(least, square_to_box(box, b));
    const double square = d.squaredNorm();
    for (const double sx : {-box.half_x, box.half_x})
      for (const double sy : {-box.half_y, box.half_y}) {
        const Vector2d from_a(sx - a.x(), sy - a.y());
        const double part = from_a.dot(d);
        if (part <= 0.0 || part >= square) continue;  // then an end of the edge is nearer
        const double across = from_a.x() * d.y() - from_a.y() * d.x();
        least = std::min(least, across * across / square);
      }
    a = b;
  }
  // No edge meets the box, so the polygon holds all of it or nothing.
  return (holds_centre ? 0.0 : std::sqrt(least)) - box.radius;
}

}  // namespace foothold::xrobin
