// Edge by edge: clipping tells crossings, corners and ends give the distance.
#include "box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polygon.hpp"

namespace foothold::xrobin {
namespace {

using Eigen::Vector2d;

double square_to_box(double half_x, double half_y, const Vector2d& p) {
  const double dx = std::max(0.0, std::abs(p.x()) - half_x);
  const double dy = std::max(0.0, std::abs(p.y()) - half_y);
  return dx * dx + dy * dy;
}

// Liang and Barsky: the part of the segment inside the box.
bool crosses(double half_x, double half_y, const Vector2d& a, const Vector2d& d) {
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
  return clip(a.x(), d.x(), half_x) && clip(a.y(), d.y(), half_y);
}

}  // namespace

double box_distance(double half_x, double half_y, std::span<const Vector2d> polygon) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2d& a = polygon[k];
    const Vector2d& b = polygon[k + 1 < polygon.size() ? k + 1 : 0];
    const Vector2d d = b - a;
    if (crosses(half_x, half_y, a, d)) return 0.0;
    least = std::min(least, square_to_box(half_x, half_y, a));
    const double square = d.squaredNorm();
    for (const double sx : {-half_x, half_x})
      for (const double sy : {-half_y, half_y}) {
        const Vector2d from_a(sx - a.x(), sy - a.y());
        const double part = from_a.dot(d);
        if (part <= 0.0 || part >= square) continue;  // then an end of the edge is nearer
        const double across = from_a.x() * d.y() - from_a.y() * d.x();
        least = std::min(least, across * across / square);
      }
  }
  // No edge meets the box, so the polygon holds all of it or nothing.
  return geometry::contains(polygon, Vector2d::Zero()) ? 0.0 : std::sqrt(least);
}

}  // namespace foothold::xrobin
