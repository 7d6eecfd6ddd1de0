// Points, segments and boxes against single triangles and each other.
//
// Two convex polytopes that do not meet are nearest between a corner of one and a face of the other, or between two edges. Both
// cases are among the pairs taken here: all edges of the box (or the segment itself) with the triangle, the triangle's corners with
// the box. They meet if one of these is 0, or if an edge of the triangle passes through the box.
#include "octopod/check/nearby.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foothold::octopod {
namespace {

double to_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d ab = b - a;
  const double length = ab.squaredNorm();
  const double t = length > 0.0 ? std::clamp((p - a).dot(ab) / length, 0.0, 1.0) : 0.0;
  return (a + t * ab - p).norm();
}

// Between two segments: inside both by the normal equations, else at an end of one of them.
double between_segments(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  double least = std::min({to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)});
  const Vector3d u = b - a, v = d - c, w = a - c;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), uw = u.dot(w), vw = v.dot(w);
  const double det = uu * vv - uv * uv;
  if (det > 1e-14 * uu * vv) {
    const double s = (uv * vw - vv * uw) / det, t = (uu * vw - uv * uw) / det;
    if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) least = std::min(least, (w + s * u - t * v).norm());
  }
  return least;
}

bool above_inside(const Vector3d& p, const Triangle& t) {
  for (std::size_t k = 0; k < 3; ++k)
    if ((t.corners[(k + 1) % 3] - t.corners[k]).cross(p - t.corners[k]).dot(t.normal) < 0.0) return false;
  return true;
}

bool pierces(const Vector3d& a, const Vector3d& b, const Triangle& t) {
  const double at_a = t.normal.dot(a - t.corners[0]), at_b = t.normal.dot(b - t.corners[0]);
  if ((at_a > 0.0) == (at_b > 0.0)) return false;
  return above_inside(a + (b - a) * (at_a / (at_a - at_b)), t);
}

// Does the segment meet the box [-half, half]? By slabs.
bool through_box(const Vector3d& a, const Vector3d& b, const Vector3d& half) {
  double from = 0.0, to = 1.0;
  for (int k = 0; k < 3; ++k) {
    const double way = b[k] - a[k];
    if (way == 0.0) {
      if (std::abs(a[k]) > half[k]) return false;
      continue;
    }
    const double enter = (-half[k] - a[k]) / way, leave = (half[k] - a[k]) / way;
    from = std::max(from, std::min(enter, leave));
    to = std::min(to, std::max(enter, leave));
  }
  return from <= to;
}

// The twelve edges of the box [-half, half].
template <class Visit>
void for_edges(const Vector3d& half, const Visit& visit) {
  const auto corner = [&](int bits) {
    return Vector3d((bits & 1) != 0 ? half.x() : -half.x(), (bits & 2) != 0 ? half.y() : -half.y(),
                    (bits & 4) != 0 ? half.z() : -half.z());
  };
  for (int bits = 0; bits < 8; ++bits)
    for (const int axis : {1, 2, 4})
      if ((bits & axis) == 0) visit(corner(bits), corner(bits | axis));
}

}  // namespace

std::vector<Triangle> triangles_in(const terrain::Terrain& terrain, const Eigen::AlignedBox3d& region) {
  std::vector<Triangle> out;
  for (std::size_t i = 0; i < terrain.size(); ++i) {
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      t.corners[k] = terrain.corner(static_cast<int>(i), static_cast<int>(k));
      t.bounds.extend(t.corners[k]);
    }
    if (!t.bounds.intersects(region)) continue;
    t.normal = (t.corners[1] - t.corners[0]).cross(t.corners[2] - t.corners[0]).normalized();
    t.ground = t.normal.z() > terrain::kLeastUp;
    out.push_back(t);
  }
  return out;
}

double distance(const Vector3d& point, const Triangle& triangle) {
  if (above_inside(point, triangle)) return std::abs(triangle.normal.dot(point - triangle.corners[0]));
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k)
    least = std::min(least, to_segment(point, triangle.corners[k], triangle.corners[(k + 1) % 3]));
  return least;
}

double distance(const Vector3d& a, const Vector3d& b, const Triangle& triangle) {
  if (pierces(a, b, triangle)) return 0.0;
  double least = std::min(distance(a, triangle), distance(b, triangle));
  for (std::size_t k = 0; k < 3; ++k)
    least = std::min(least, between_segments(a, b, triangle.corners[k], triangle.corners[(k + 1) % 3]));
  return least;
}

double distance(const Isometry3d& box, const Vector3d& half, const Triangle& triangle) {
  Triangle seen = triangle;
  const Isometry3d back = box.inverse();
  for (Vector3d& corner : seen.corners) corner = back * corner;
  seen.normal = back.linear() * triangle.normal;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    if (through_box(seen.corners[k], seen.corners[(k + 1) % 3], half)) return 0.0;
    least = std::min(least, (seen.corners[k].cwiseAbs() - half).cwiseMax(0.0).norm());
  }
  for_edges(half, [&](const Vector3d& from, const Vector3d& to) { least = std::min(least, distance(from, to, seen)); });
  return least;
}

double distance(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) { return between_segments(a, b, c, d); }

double distance(const Isometry3d& box, const Vector3d& half, const Vector3d& a, const Vector3d& b) {
  const Isometry3d back = box.inverse();
  const Vector3d from = back * a, to = back * b;
  if (through_box(from, to, half)) return 0.0;
  double least = std::min((from.cwiseAbs() - half).cwiseMax(0.0).norm(), (to.cwiseAbs() - half).cwiseMax(0.0).norm());
  for_edges(half, [&](const Vector3d& c, const Vector3d& d) { least = std::min(least, between_segments(from, to, c, d)); });
  return least;
}

double distance(const Isometry3d& a, const Vector3d& half_a, const Isometry3d& b, const Vector3d& half_b) {
  double least = std::numeric_limits<double>::infinity();
  for_edges(half_a, [&](const Vector3d& c, const Vector3d& d) { least = std::min(least, distance(b, half_b, a * c, a * d)); });
  for_edges(half_b, [&](const Vector3d& c, const Vector3d& d) { least = std::min(least, distance(a, half_a, b * c, b * d)); });
  return least;
}

}  // namespace foothold::octopod
