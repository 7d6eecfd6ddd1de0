// Convex hulls of a handful of points, and distances to their edges.
#include "contact/support_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace foothold::contact {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Twice the area of (a, b, c) seen from above: positive if c lies left of a -> b.
double turn(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double distance_to_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d d = b - a;
  const double squared = d.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(d) / squared, 0.0, 1.0) : 0.0;
  return (a + t * d - p).norm();
}

}  // namespace

SupportPolygon support_polygon(std::span<const Vector3d> contacts) {
  if (contacts.size() > SupportPolygon::kMostContacts)
    throw std::invalid_argument("a support polygon takes up to " + std::to_string(SupportPolygon::kMostContacts) +
                                " contacts, not " + std::to_string(contacts.size()));
  std::array<Vector3d, SupportPolygon::kMostContacts> sorted;
  const auto end = std::copy(contacts.begin(), contacts.end(), sorted.begin());
  std::sort(sorted.begin(), end,
            [](const Vector3d& a, const Vector3d& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  SupportPolygon out;
  const auto add = [&](const Vector3d& p, std::size_t floor) {
    while (out.count >= floor + 2 && turn(out.corners[out.count - 2], out.corners[out.count - 1], p) <= 0.0) --out.count;
    out.corners[out.count++] = p;
  };
  for (auto p = sorted.begin(); p != end; ++p) add(*p, 0);
  const std::size_t lower = out.count;
  for (std::size_t i = contacts.size(); i-- > 1;) add(sorted[i - 1], lower - 1);
  if (contacts.size() > 1) --out.count;  // the first corner stands at the end again
  return out;
}

double projected_margin(const SupportPolygon& polygon, const Vector3d& centre_of_mass) {
  if (polygon.count == 0) return -std::numeric_limits<double>::infinity();
  const Vector2d p = centre_of_mass.head<2>();
  if (polygon.count < 3) return -distance_to_segment(p, polygon.corners[0].head<2>(), polygon.corners[polygon.count - 1].head<2>());
  bool inside = true;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vector3d &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.count];
    inside = inside && turn(a, b, centre_of_mass) >= 0.0;
    least = std::min(least, distance_to_segment(p, a.head<2>(), b.head<2>()));
  }
  return inside ? least : -least;
}

}  // namespace foothold::contact
