// Flat polygons: Sutherland and Hodgman's clipping, Newell's normal, ear clipping.
#include "polygon.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace foothold::drawing {
namespace {

double signed_area(const Points& polygon) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) twice += flat_cross(polygon[0], polygon[i], polygon[i + 1]);
  return twice / 2.0;
}

// Coordinates in the polygon's own plane, counter-clockwise; z is 0.
Points flattened(const Points& polygon, const Vector3d& normal) {
  const Vector3d n = normal.normalized();
  const Vector3d u = n.unitOrthogonal();
  const Vector3d v = n.cross(u);
  Points flat;
  for (const Vector3d& p : polygon) flat.emplace_back((p - polygon[0]).dot(u), (p - polygon[0]).dot(v), 0.0);
  return flat;
}

// Is p inside the triangle, border excluded by `slack` (an area)?
bool strictly_inside(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& p, double slack) {
  return flat_cross(a, b, p) > slack && flat_cross(b, c, p) > slack && flat_cross(c, a, p) > slack;
}

bool is_convex(const Points& flat, double slack) {
  const std::size_t n = flat.size();
  double turn = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3d edge = flat[(i + 1) % n] - flat[i], next = flat[(i + 2) % n] - flat[(i + 1) % n];
    const double cross = edge.x() * next.y() - edge.y() * next.x();
    if (cross < -slack) return false;
    turn += std::atan2(cross, edge.head<2>().dot(next.head<2>()));
  }
  // A star polygon turns one way only too, but more than once.
  return turn < 3.0 * M_PI;
}

bool segments_cross(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d, double slack) {
  const double c_side = flat_cross(a, b, c), d_side = flat_cross(a, b, d), a_side = flat_cross(c, d, a),
               b_side = flat_cross(c, d, b);
  const auto opposite = [slack](double x, double y) { return (x > slack && y < -slack) || (x < -slack && y > slack); };
  return opposite(c_side, d_side) && opposite(a_side, b_side);
}

bool crosses_itself(const Points& flat, double slack) {
  const std::size_t n = flat.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = i + 2; k < n; ++k)
      if (!(i == 0 && k == n - 1) && segments_cross(flat[i], flat[i + 1], flat[k], flat[(k + 1) % n], slack)) return true;
  return false;
}

}  // namespace

Vector3d newell(const Points& polygon) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  return sum;
}

double flat_area(const Points& polygon) { return std::abs(signed_area(polygon)); }

double flat_turn(const Points& polygon) { return signed_area(polygon) < 0.0 ? -1.0 : 1.0; }

Vector3d mean(const Points& polygon) {
  const Vector3d sum = std::accumulate(polygon.begin(), polygon.end(), Vector3d(Vector3d::Zero()));
  return sum / static_cast<double>(polygon.size());
}

Box2 flat_bounds(const Points& polygon) {
  Box2 box{polygon[0].head<2>(), polygon[0].head<2>()};
  for (const Vector3d& p : polygon) {
    box.low = box.low.cwiseMin(p.head<2>());
    box.high = box.high.cwiseMax(p.head<2>());
  }
  return box;
}

Points overlap(const Points& a, const Points& b) {
  const double side = flat_turn(b);
  Points rest = a;
  for (std::size_t i = 0; i < b.size() && rest.size() >= 3; ++i) {
    const Vector3d &from = b[i], &to = b[(i + 1) % b.size()];
    rest = clipped(rest, [&](const Vector3d& p) { return side * flat_cross(from, to, p); });
  }
  if (rest.size() < 3) rest.clear();
  return rest;
}

bool covers(const Points& convex, const Vector3d& point) {
  const double side = flat_turn(convex);
  for (std::size_t i = 0; i < convex.size(); ++i)
    if (side * flat_cross(convex[i], convex[(i + 1) % convex.size()], point) < 0.0) return false;
  return convex.size() >= 3;
}

std::optional<DepthPlane> depth_plane(const Points& face) {
  const Vector3d n = newell(face);
  constexpr double kEdgeOn = 1e-9;
  if (std::abs(n.z()) <= kEdgeOn * n.norm()) return std::nullopt;
  const Vector3d& p = face[0];
  return DepthPlane{-n.x() / n.z(), -n.y() / n.z(), n.dot(p) / n.z()};
}

std::vector<ConvexPiece> convex_pieces(const Points& polygon) {
  const Vector3d normal = newell(polygon);
  double reach = 0.0;
  for (const Vector3d& p : polygon) reach = std::max(reach, (p - polygon[0]).norm());
  const double slack = 1e-12 * reach * reach;
  const std::vector<ConvexPiece> whole{{polygon, std::vector<bool>(polygon.size(), true)}};
  if (normal.norm() <= slack) return whole;
  const Points flat = flattened(polygon, normal);
  if (is_convex(flat, slack)) return whole;
  if (crosses_itself(flat, slack)) return {};

  // Ears, each with the vertices' numbers in the whole polygon; an edge between neighbours in it lies on the outline.
  std::vector<std::size_t> left(polygon.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  std::vector<ConvexPiece> pieces;
  const auto emit = [&](std::size_t a, std::size_t b, std::size_t c) {
    const auto neighbours = [&](std::size_t from, std::size_t to) { return (from + 1) % polygon.size() == to; };
    pieces.push_back({{polygon[a], polygon[b], polygon[c]}, {neighbours(a, b), neighbours(b, c), neighbours(c, a)}});
  };
  while (left.size() > 3) {
    bool found = false;
    for (std::size_t i = 0; i < left.size() && !found; ++i) {
      const std::size_t before = left[(i + left.size() - 1) % left.size()], ear = left[i], after = left[(i + 1) % left.size()];
      const double turn = flat_cross(flat[before], flat[ear], flat[after]);
      if (turn < -slack) continue;
      const bool free = turn <= slack || std::none_of(left.begin(), left.end(), [&](std::size_t k) {
                          return k != before && k != ear && k != after &&
                                 strictly_inside(flat[before], flat[ear], flat[after], flat[k], -slack) &&
                                 (flat[k] - flat[before]).norm() > 0.0 && (flat[k] - flat[after]).norm() > 0.0;
                        });
      if (!free) continue;
      emit(before, ear, after);
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      found = true;
    }
    if (!found) return {};
  }
  emit(left[0], left[1], left[2]);
  return pieces;
}

}  // namespace foothold::drawing
