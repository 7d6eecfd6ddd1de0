// Flat polygons: clipping, areas, overlaps of convex ones, convex pieces of any simple one.
//
// A screen point is (x, y, depth): pixels to the right and down, and pixels towards the viewer. Over a flat face the depth is an
// affine function of x and y, so that clipping interpolates it exactly.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace foothold::drawing {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

// The part of a convex polygon (or segment, or point) where the affine function `value` is not below 0.
template <class Value>
Points clipped(const Points& polygon, Value&& value) {
  Points kept;
  kept.reserve(polygon.size() + 1);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3d& a = polygon[i];
    const Vector3d& b = polygon[(i + 1) % polygon.size()];
    const double at_a = value(a), at_b = value(b);
    if (at_a >= 0.0) kept.push_back(a);
    // A segment's way back from its second point to its first is the same way: cut it once.
    if (polygon.size() == 2 && i == 1) break;
    if ((at_a < 0.0) != (at_b < 0.0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  return kept;
}

// Twice the signed area's vector (Newell): along the normal round which the vertices go counter-clockwise.
Vector3d newell(const Points& polygon);
// Area in x and y, not below 0.
double flat_area(const Points& polygon);
// Twice the signed area of the triangle a, b, p in x and y: above 0 if p lies to the left of the way from a to b (y upwards).
inline double flat_cross(const Vector3d& a, const Vector3d& b, const Vector3d& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}
// 1 if the polygon goes round counter-clockwise in x and y (y upwards), else -1.
double flat_turn(const Points& polygon);
Vector3d mean(const Points& polygon);

struct Box2 {
  Vector2d low, high;
  bool meets(const Box2& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};
// Of a polygon with one vertex at least.
Box2 flat_bounds(const Points& polygon);

// Where two convex polygons overlap in x and y; the depths are those of `a`. Empty if the overlap is thinner than rounding.
Points overlap(const Points& a, const Points& b);

// Is (x, y) of the point inside the convex polygon, its border included?
bool covers(const Points& convex, const Vector3d& point);

// Depth over (x, y) of a flat face; nothing when the face is seen edge-on.
struct DepthPlane {
  double along_x, along_y, at_zero;
  double operator()(const Vector3d& p) const { return along_x * p.x() + along_y * p.y() + at_zero; }
};
std::optional<DepthPlane> depth_plane(const Points& face);

// A convex polygon whose edge i (from vertex i to the next) lies on the outline of what it was cut from, or not.
struct ConvexPiece {
  Points points;
  std::vector<bool> outline;
};

// A flat simple polygon as convex pieces: itself when it is convex, else its triangles (ears). Empty when it crosses itself.
// Repeated and collinear vertices are allowed; a polygon without area gives itself.
std::vector<ConvexPiece> convex_pieces(const Points& polygon);

}  // namespace foothold::drawing
