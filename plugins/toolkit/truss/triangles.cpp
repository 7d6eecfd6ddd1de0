// Simple polygons to convex pieces, by ear clipping.
#include <numeric>

#include "truss/layout.hpp"

namespace foothold::truss {
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

std::vector<Polygon> convex_pieces(const Polygon& polygon) {
  if (convex(polygon)) return {polygon};
  std::vector<std::size_t> left(polygon.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  std::vector<Polygon> pieces;
  const auto ear = [&](std::size_t k) {
    const std::size_t n = left.size();
    const std::size_t ia = left[(k + n - 1) % n], ib = left[k], ic = left[(k + 1) % n];
    const Vector2d &a = polygon[ia], &b = polygon[ib], &c = polygon[ic];
    if (turn(a, b, c) <= 0.0) return false;
    for (const std::size_t other : left)
      if (other != ia && other != ib && other != ic && inside(polygon[other], a, b, c)) return false;
    return true;
  };
  while (left.size() > 3) {
    std::size_t k = 0;
    while (k < left.size() && !ear(k)) ++k;
    const std::size_t n = left.size();
    if (k == n) {
      // Only corners on a straight line are left over: they bound nothing.
      const auto straight = [&](std::size_t i) {
        return turn(polygon[left[(i + n - 1) % n]], polygon[left[i]], polygon[left[(i + 1) % n]]) == 0.0;
      };
      for (k = 0; k + 1 < n && !straight(k);) ++k;
    } else {
      pieces.push_back({polygon[left[(k + n - 1) % n]], polygon[left[k]], polygon[left[(k + 1) % n]]});
    }
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
  }
  if (turn(polygon[left[0]], polygon[left[1]], polygon[left[2]]) > 0.0)
    pieces.push_back({polygon[left[0]], polygon[left[1]], polygon[left[2]]});
  return pieces;
}

}  // namespace foothold::truss
