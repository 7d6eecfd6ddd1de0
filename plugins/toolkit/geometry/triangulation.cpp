// Simple polygons to convex pieces, by ear clipping.
#include "geometry/triangulation.hpp"

#include <numeric>

namespace foothold::geometry {
namespace {

double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b - a).x() * (c - b).y() - (b - a).y() * (c - b).x();
}

bool convex(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t k = 0; k < n; ++k)
    if (turn(polygon[k], polygon[(k + 1) % n], polygon[(k + 2) % n]) < 0.0) return false;
  return true;
}

bool inside(const Vector2d& p, const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
}

}  // namespace

std::vector<std::array<std::size_t, 3>> triangulated(const Polygon& polygon) {
  std::vector<std::size_t> left(polygon.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  std::vector<std::array<std::size_t, 3>> triangles;
  const auto corner = [&](std::size_t k) -> std::array<std::size_t, 3> {
    const std::size_t n = left.size();
    return {left[(k + n - 1) % n], left[k], left[(k + 1) % n]};
  };
  const auto turn_at = [&](std::size_t k) {
    const auto [a, b, c] = corner(k);
    return turn(polygon[a], polygon[b], polygon[c]);
  };
  const auto ear = [&](std::size_t k) {
    if (turn_at(k) <= 0.0) return false;
    const auto [a, b, c] = corner(k);
    for (const std::size_t other : left)
      if (other != a && other != b && other != c && inside(polygon[other], polygon[a], polygon[b], polygon[c])) return false;
    return true;
  };
  while (left.size() > 2) {
    std::size_t k = 0;
    while (k < left.size() && !ear(k)) ++k;
    if (k < left.size())
      triangles.push_back(corner(k));
    else  // only corners on a straight line are left over: they bound nothing
      for (k = 0; k + 1 < left.size() && turn_at(k) != 0.0;) ++k;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return triangles;
}

std::vector<Polygon> convex_pieces(const Polygon& polygon) {
  if (convex(polygon)) return {polygon};
  std::vector<Polygon> pieces;
  for (const auto& [a, b, c] : triangulated(polygon)) pieces.push_back({polygon[a], polygon[b], polygon[c]});
  return pieces;
}

}  // namespace foothold::geometry
