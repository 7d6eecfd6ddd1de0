// Vertex against edge, both ways; crossings by orientation signs.
#include "geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foothold::geometry {
namespace {

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double orientation(const Vector2d& a, const Vector2d& b, const Vector2d& c) { return cross(b - a, c - a); }

bool in_box(const Vector2d& a, const Vector2d& b, const Vector2d& p) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) && std::min(a.y(), b.y()) <= p.y() &&
         p.y() <= std::max(a.y(), b.y());
}

bool touch(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const double abc = orientation(a, b, c);
  const double abd = orientation(a, b, d);
  const double cda = orientation(c, d, a);
  const double cdb = orientation(c, d, b);
  if (((abc > 0.0 && abd < 0.0) || (abc < 0.0 && abd > 0.0)) && ((cda > 0.0 && cdb < 0.0) || (cda < 0.0 && cdb > 0.0))) return true;
  return (abc == 0.0 && in_box(a, b, c)) || (abd == 0.0 && in_box(a, b, d)) || (cda == 0.0 && in_box(c, d, a)) ||
         (cdb == 0.0 && in_box(c, d, b));
}

// Least distance between the boundaries; edges as pairs of consecutive points, closed or open.
double boundary_distance(std::span<const Vector2d> a, bool a_closed, std::span<const Vector2d> b) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!a_closed && i + 1 == a.size()) break;
    for (std::size_t k = 0; k < b.size(); ++k)
      least = std::min(least, distance(a[i], a[(i + 1) % a.size()], b[k], b[(k + 1) % b.size()]));
  }
  return least;
}

}  // namespace

double signed_area(std::span<const Vector2d> polygon) {
  double twice = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    twice += cross(polygon[k] - polygon[0], polygon[(k + 1) % polygon.size()] - polygon[0]);
  return 0.5 * twice;
}

double distance(const Vector2d& point, const Vector2d& a, const Vector2d& b) {
  const Vector2d along = b - a;
  const double square = along.squaredNorm();
  const double part = square > 0.0 ? std::clamp((point - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (point - a - part * along).norm();
}

double distance(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  if (touch(a, b, c, d)) return 0.0;
  return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

bool contains(std::span<const Vector2d> polygon, const Vector2d& point) {
  bool inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2d& a = polygon[k];
    const Vector2d& b = polygon[(k + 1) % polygon.size()];
    if ((a.y() > point.y()) != (b.y() > point.y()) && point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  return inside;
}

double distance(std::span<const Vector2d> a, std::span<const Vector2d> b) {
  if (contains(a, b[0]) || contains(b, a[0])) return 0.0;
  return boundary_distance(a, true, b);
}

double distance(std::span<const Vector2d> polygon, const Vector2d& a, const Vector2d& b) {
  if (contains(polygon, a)) return 0.0;
  const Vector2d ends[] = {a, b};
  return boundary_distance(ends, false, polygon);
}

double distance(std::span<const Vector2d> polygon, const Vector2d& point) {
  if (contains(polygon, point)) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < polygon.size(); ++k)
    least = std::min(least, distance(point, polygon[k], polygon[(k + 1) % polygon.size()]));
  return least;
}

std::optional<std::size_t> first_crossing(std::span<const Vector2d> polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vector2d& a = polygon[k];
    const Vector2d& b = polygon[(k + 1) % n];
    const Vector2d& c = polygon[(k + 2) % n];
    // Neighbours share a vertex; they fold back if they run along each other beyond it.
    if (orientation(a, b, c) == 0.0 && (b - a).dot(c - b) < 0.0) return (k + 1) % n;
    for (std::size_t i = 0; i + 1 < k; ++i) {
      if (i == 0 && k + 1 == n) continue;
      if (touch(polygon[i], polygon[i + 1], a, b)) return k;
    }
  }
  return std::nullopt;
}

Circle circle_round(std::span<const Vector2d> points) {
  Vector2d low = points[0];
  Vector2d high = points[0];
  for (const Vector2d& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  Circle circle{0.5 * (low + high), 0.0};
  for (const Vector2d& p : points) circle.radius = std::max(circle.radius, (p - circle.centre).norm());
  return circle;
}

}  // namespace foothold::geometry
