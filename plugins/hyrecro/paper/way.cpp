#include "hyrecro/paper/way.hpp"

#include <cmath>
#include <limits>

namespace foothold::hyrecro {
namespace {

constexpr double kGrid = 0.1;  // m, neighbourhood of the A* of Zhu et al. (paper, section 4.1)

}  // namespace

SafeGround::SafeGround(const truss::Face& face, double inset) {
  for (const Region& region : shrunk(face, inset)) parts_.emplace_back(region.outline, region.holes);
}

bool SafeGround::holds(const Vector2d& point) const {
  for (const geometry::PolygonPaths& part : parts_)
    if (part.holds(point)) return true;
  return false;
}

std::vector<Vector2d> SafeGround::way(const Vector2d& from, const Vector2d& to, FaceWay how) const {
  const auto part_near = [&](const Vector2d& point) {
    const geometry::PolygonPaths* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const geometry::PolygonPaths& part : parts_)
      if (const double far = (part.nearest(point) - point).norm(); far < least) least = far, best = &part;
    return best;
  };
  const geometry::PolygonPaths* const part = part_near(from);
  if (!part || part != part_near(to)) return {};
  const Vector2d in = part->nearest(from), out = part->nearest(to);
  std::vector<Vector2d> way = how == FaceWay::kVisibility
                                  ? part->path(in, out)
                                  : geometry::grid_path(*part, in, out, kGrid, geometry::GridNeighbours::kEight);
  if (way.empty()) return way;
  if ((in - from).norm() > geometry::kOnBoundary) way.insert(way.begin(), from);
  if ((out - to).norm() > geometry::kOnBoundary) way.push_back(to);
  way.front() = from;
  way.back() = to;
  return way;
}

Vector2d crossing(const std::vector<Vector2d>& way, const Vector2d& centre, double radius) {
  if ((way.back() - centre).norm() <= radius) return way.back();
  Vector2d nearest = way.front();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = way.size() - 1; k > 0; --k) {
    const Vector2d& a = way[k - 1];
    const Vector2d along = way[k] - a, off = a - centre;
    // |off + s along| = radius, the greater root.
    const double square = along.squaredNorm(), half = off.dot(along), rest = off.squaredNorm() - radius * radius;
    if (square == 0.0) continue;
    const double inside = half * half - square * rest;
    const double foot = std::fmin(1.0, std::fmax(0.0, -half / square));
    if (inside >= 0.0) {
      const double s = (-half + std::sqrt(inside)) / square;
      if (s >= 0.0 && s <= 1.0) return a + s * along;
    }
    if (const double far = (off + foot * along).norm(); far < least) least = far, nearest = a + foot * along;
  }
  return nearest;
}

}  // namespace foothold::hyrecro
