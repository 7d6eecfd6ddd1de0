// Convex plane polygons without thickness against capsules and boxes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/segments.hpp"

namespace foothold::collision {
namespace {

const Vector3d& after(const Patch& patch, std::size_t k) { return patch.vertices[k + 1 < patch.vertices.size() ? k + 1 : 0]; }

// Unit normal by the sum of the triangles' areas; zero for a polygon that has none.
Vector3d normal_of(const Patch& patch) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t k = 1; k + 1 < patch.vertices.size(); ++k)
    sum += (patch.vertices[k] - patch.vertices[0]).cross(patch.vertices[k + 1] - patch.vertices[0]);
  const double norm = sum.norm();
  return norm > 1e-300 ? Vector3d(sum / norm) : Vector3d::Zero();
}

// The point's foot in the plane lies inside.
bool above(const Patch& patch, const Vector3d& normal, const Vector3d& point) {
  for (std::size_t k = 0; k < patch.vertices.size(); ++k)
    if (normal.dot((after(patch, k) - patch.vertices[k]).cross(point - patch.vertices[k])) < 0.0) return false;
  return true;
}

// Of the segment p-q to the polygon's inner: 0 where it passes through, else the lower end above it; infinite if neither is.
double squared_inside(const Patch& patch, const Vector3d& normal, const Vector3d& p, const Vector3d& q) {
  if (normal.isZero(0.0)) return std::numeric_limits<double>::infinity();
  const double at_p = normal.dot(p - patch.vertices[0]), at_q = normal.dot(q - patch.vertices[0]);
  if ((at_p <= 0.0) != (at_q <= 0.0)) {
    const Vector3d crossing = p + (at_p / (at_p - at_q)) * (q - p);
    if (above(patch, normal, crossing)) return 0.0;
  }
  double best = std::numeric_limits<double>::infinity();
  if (above(patch, normal, p)) best = at_p * at_p;
  if (above(patch, normal, q)) best = std::min(best, at_q * at_q);
  return best;
}

double squared_distance(const Capsule& a, const Patch& b) {
  double best = squared_inside(b, normal_of(b), a.a, a.b);
  for (std::size_t k = 0; k < b.vertices.size() && best > 0.0; ++k)
    best = std::min(best, squared_of_segments(a.a, a.b, b.vertices[k], after(b, k)));
  return best;
}

Vector3d into(const Box& box, const Vector3d& point) {
  return box.pose.linear().transpose() * (point - Vector3d(box.pose.translation()));
}

std::array<Vector3d, 8> corners_of_box(const Box& box) {
  const Eigen::Matrix3d axes = box.pose.linear();
  return corners_of(box.pose.translation(), box.half.x() * axes.col(0), box.half.y() * axes.col(1), box.half.z() * axes.col(2));
}

// The greatest gap between the shapes along `axis` and its reverse; negative infinity for a zero axis.
double gap_along(const Box& box, const Patch& patch, const Vector3d& axis) {
  const double length = axis.norm();
  if (length < 1e-10) return -std::numeric_limits<double>::infinity();
  const Vector3d unit = axis / length;
  const double centre = unit.dot(Vector3d(box.pose.translation()));
  const double extent = (box.pose.linear().transpose() * unit).cwiseAbs().dot(box.half);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vector3d& vertex : patch.vertices) {
    const double at = unit.dot(vertex) - centre;
    low = std::min(low, at), high = std::max(high, at);
  }
  return std::max(low, -high) - extent;
}

// Separating axes: the box's faces, the polygon's plane, each pair of edges. As greatest_gap() of two boxes.
double greatest_gap(const Box& box, const Patch& patch, double enough) {
  const Eigen::Matrix3d axes = box.pose.linear();
  double best = gap_along(box, patch, normal_of(patch));
  for (Eigen::Index i = 0; i < 3 && best < enough; ++i) best = std::max(best, gap_along(box, patch, axes.col(i)));
  for (std::size_t k = 0; k < patch.vertices.size() && best < enough; ++k) {
    const Vector3d edge = (after(patch, k) - patch.vertices[k]).normalized();
    for (Eigen::Index i = 0; i < 3 && best < enough; ++i) best = std::max(best, gap_along(box, patch, axes.col(i).cross(edge)));
  }
  return best;
}

double squared_distance(const Box& a, const Patch& b) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < b.vertices.size() && best > 0.0; ++k) {
    const Vector3d p = into(a, b.vertices[k]), q = into(a, after(b, k));
    if (squared_bound(p, q, a.half) < best) best = std::min(best, squared_to_box(p, q, a.half));
  }
  const Vector3d normal = normal_of(b);
  const std::array<Vector3d, 8> corners = corners_of_box(a);
  for (std::size_t k = 0; k < kEdges.size() && best > 0.0; ++k)
    best = std::min(best, squared_inside(b, normal, corners[kEdges[k].first], corners[kEdges[k].second]));
  return best;
}

}  // namespace

double distance(const Capsule& a, const Patch& b) { return std::max(0.0, std::sqrt(squared_distance(a, b)) - a.radius); }

bool nearer(const Capsule& a, const Patch& b, double clearance) {
  const double sum = a.radius + clearance;
  return squared_distance(a, b) < sum * sum;
}

double distance(const Box& a, const Patch& b) { return std::sqrt(squared_distance(a, b)); }

bool nearer(const Box& a, const Patch& b, double clearance) {
  if (greatest_gap(a, b, clearance) >= clearance) return false;
  return clearance <= 0.0 || squared_distance(a, b) < clearance * clearance;
}

}  // namespace foothold::collision
