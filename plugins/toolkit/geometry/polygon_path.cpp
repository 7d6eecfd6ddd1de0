// Visibility by the sides of lines: a segment stays inside if it crosses no edge and leaves no vertex into the outside.
#include "geometry/polygon_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace foothold::geometry {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kOnStack = 48;  // reflex vertices that a query needs no heap for

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

PolygonPaths::PolygonPaths(const Polygon& outline, const std::vector<Polygon>& holes) {
  add(outline);
  for (const Polygon& hole : holes) add(hole);
  for (std::size_t k = 0; k < edges_.size(); ++k)
    if (edges_[k].reflex) reflex_.push_back(static_cast<int>(k));
  const int count = static_cast<int>(reflex_.size());
  links_.assign(reflex_.size() * reflex_.size(), {kInfinity, -1});
  const auto at = [&](int a, int b) -> Link& { return links_[static_cast<std::size_t>(a * count + b)]; };
  for (int a = 0; a < count; ++a) {
    at(a, a) = {0.0, a};
    for (int b = 0; b < count; ++b)
      if (a != b && sees(reflex(a).at, reflex(b).at)) at(a, b) = {(reflex(a).at - reflex(b).at).norm(), b};
  }
  for (int via = 0; via < count; ++via)
    for (int a = 0; a < count; ++a)
      for (int b = 0; b < count; ++b)
        if (const double through = at(a, via).length + at(via, b).length; through < at(a, b).length)
          at(a, b) = {through, at(a, via).next};
}

void PolygonPaths::add(const Polygon& ring) {
  const int first = static_cast<int>(edges_.size()), count = static_cast<int>(ring.size());
  for (int k = 0; k < count; ++k) {
    const Vector2d& before = ring[static_cast<std::size_t>((k + count - 1) % count)];
    const Vector2d& at = ring[static_cast<std::size_t>(k)];
    const Vector2d& after = ring[static_cast<std::size_t>((k + 1) % count)];
    const Vector2d along = (after - at).normalized(), normal{-along.y(), along.x()};
    edges_.push_back({at, normal, normal.dot(at), first + (k + count - 1) % count, first + (k + 1) % count,
                      cross(at - before, after - at) < 0.0});
  }
}

bool PolygonPaths::holds(const Vector2d& point) const {
  bool inside = false;
  for (const Edge& one : edges_) {
    const Vector2d& a = one.at;
    const Vector2d& b = edge(one.after).at;
    if (distance(point, a, b) <= kOnBoundary) return true;
    if ((a.y() > point.y()) != (b.y() > point.y()) && (one.side(point) > 0.0) == (b.y() > a.y())) inside = !inside;
  }
  return inside;
}

bool PolygonPaths::sees(const Vector2d& from, const Vector2d& to) const {
  const Vector2d way = to - from;
  const double length = way.norm();
  if (length <= kOnBoundary) return true;
  const Vector2d along = way / length;
  for (const Edge& one : edges_) {
    const double side_from = one.side(from), side_to = one.side(to);
    const auto [low, high] = std::minmax(side_from, side_to);
    if (low > kOnBoundary || high < -kOnBoundary) continue;
    const Vector2d to_a = one.at - from;
    const double turn_a = cross(along, to_a);
    if (std::fabs(turn_a) <= kOnBoundary) {
      // Through a vertex, or from or to one: each part of the way must lie in the wedge between its edges.
      const double reached = along.dot(to_a);
      if (reached < -kOnBoundary || reached > length + kOnBoundary) continue;
      const auto inside = [&](double side, double side_before) {
        const bool here = side >= -kOnBoundary, there = side_before >= -kOnBoundary;
        return one.reflex ? here || there : here && there;
      };
      const Edge& before = edge(one.before);
      if (reached > kOnBoundary && !inside(side_from, before.side(from))) return false;
      if (reached < length - kOnBoundary && !inside(side_to, before.side(to))) return false;
      continue;
    }
    const double turn_b = cross(along, edge(one.after).at - from);
    if (std::fabs(turn_b) <= kOnBoundary || (turn_a > 0.0) == (turn_b > 0.0)) continue;
    // The way's line crosses the edge; an end that lies on the edge may leave it to the inside.
    if (low < -kOnBoundary) return false;
  }
  return true;
}

// Whether a way that comes straight from `from` can bend round the corner: both its edges on one side of the way.
bool PolygonPaths::tangent(const Vector2d& from, const Edge& corner) const {
  const double side = corner.side(from), side_before = edge(corner.before).side(from);
  return (side >= -kOnBoundary && side_before <= kOnBoundary) || (side <= kOnBoundary && side_before >= -kOnBoundary);
}

PolygonPaths::Bends PolygonPaths::shortest(const Vector2d& from, const Vector2d& to) const {
  Bends best;
  best.length = kInfinity;
  if (!holds(from)) return best;
  if (sees(from, to)) {
    best.length = (to - from).norm();
    return best;
  }
  if (!holds(to)) return best;
  std::array<double, kOnStack> small;
  std::vector<double> large(reflex_.size() > kOnStack ? reflex_.size() : 0);
  double* const begin = large.empty() ? small.data() : large.data();
  const int count = static_cast<int>(reflex_.size());
  for (int k = 0; k < count; ++k) {
    const Edge& corner = reflex(k);
    begin[k] = tangent(from, corner) && sees(from, corner.at) ? (corner.at - from).norm() : kInfinity;
  }
  for (int k = 0; k < count; ++k) {
    const Edge& corner = reflex(k);
    const double rest = (corner.at - to).norm();
    double least = kInfinity;
    int first = -1;
    for (int i = 0; i < count; ++i)
      if (const double through = begin[i] + link(i, k).length; through < least) least = through, first = i;
    if (least + rest >= best.length || !tangent(to, corner) || !sees(to, corner.at)) continue;
    best = {first, k, least + rest};
  }
  return best;
}

double PolygonPaths::length(const Vector2d& from, const Vector2d& to) const { return shortest(from, to).length; }

std::vector<Vector2d> PolygonPaths::path(const Vector2d& from, const Vector2d& to) const {
  const Bends bends = shortest(from, to);
  if (!std::isfinite(bends.length)) return {};
  std::vector<Vector2d> out;
  out.reserve(8);
  out.push_back(from);
  const auto append = [&](const Vector2d& point) {
    if ((point - out.back()).norm() > kOnBoundary) out.push_back(point);
  };
  if (bends.first >= 0) {
    append(reflex(bends.first).at);
    for (int at = bends.first; at != bends.last;) {
      at = link(at, bends.last).next;
      append(reflex(at).at);
    }
  }
  if ((to - out.back()).norm() > kOnBoundary || out.size() == 1)
    out.push_back(to);
  else
    out.back() = to;
  return out;
}

Vector2d PolygonPaths::nearest(const Vector2d& point) const {
  if (holds(point)) return point;
  Vector2d best = point;
  double least = kInfinity;
  for (const Edge& one : edges_) {
    const Vector2d way = edge(one.after).at - one.at;
    const Vector2d there = one.at + std::clamp((point - one.at).dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
    if (const double far = (there - point).norm(); far < least) least = far, best = there;
  }
  return best;
}

}  // namespace foothold::geometry
