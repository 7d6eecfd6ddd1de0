// Which places of a face a gripper may hold at.
#include <cmath>

#include "hyrecro/scene/transitions.hpp"

namespace foothold::hyrecro {
namespace {

constexpr double kEdge = 1e-9;  // m: what counts as on the edge

// The segment meets the open box |x| < half.x, |y| < half.y.
bool enters(Vector2d a, const Vector2d& b, const Vector2d& half) {
  double from = 0.0, to = 1.0;
  for (Eigen::Index k = 0; k < 2; ++k) {
    const double way = b[k] - a[k];
    if (way == 0.0) {
      if (std::abs(a[k]) >= half[k]) return false;
      continue;
    }
    const double s = (-half[k] - a[k]) / way, t = (half[k] - a[k]) / way;
    from = std::max(from, std::min(s, t));
    to = std::min(to, std::max(s, t));
  }
  return from < to;
}

bool contains(const truss::Face& face, const Vector2d& point) {
  if (!geometry::contains(std::span<const Vector2d>(face.outline), point)) return false;
  for (const Polygon& hole : face.holes)
    if (geometry::contains(std::span<const Vector2d>(hole), point)) return false;
  return true;
}

double distance_to_edges(const truss::Face& face, const Vector2d& point) {
  double least = INFINITY;
  const auto ring = [&](const Polygon& polygon) {
    for (std::size_t k = 0; k < polygon.size(); ++k)
      least = std::min(least, geometry::distance(point, polygon[k], polygon[(k + 1) % polygon.size()]));
  };
  ring(face.outline);
  for (const Polygon& hole : face.holes) ring(hole);
  return least;
}

}  // namespace

std::vector<Region> shrunk(const truss::Face& face, double inset) { return geometry::inset({face.outline, face.holes}, inset); }

bool plate_on_face(const Model& model, const truss::Face& face, const Foothold& foothold) {
  if (!contains(face, foothold.at)) return false;
  const double c = std::cos(foothold.heading), s = std::sin(foothold.heading);
  const Vector2d half = 0.5 * model.plate.head<2>() - Vector2d::Constant(kEdge);
  const auto local = [&](const Vector2d& v) {
    const Vector2d way = v - foothold.at;
    return Vector2d(c * way.x() + s * way.y(), c * way.y() - s * way.x());
  };
  // The centre is on the face, so the plate is unless some edge passes under it.
  const auto passes = [&](const Polygon& ring) {
    Vector2d a = local(ring.back());
    for (const Vector2d& vertex : ring) {
      const Vector2d b = local(vertex);
      if (enters(a, b, half)) return true;
      a = b;
    }
    return false;
  };
  if (passes(face.outline)) return false;
  for (const Polygon& hole : face.holes)
    if (passes(hole)) return false;
  return true;
}

std::optional<Foothold> foothold_at(const truss::Truss& truss, const Isometry3d& pose, double tolerance) {
  std::optional<Foothold> best;
  double farthest = -1.0;
  for (std::size_t f = 0; f < truss.faces.size(); ++f) {
    const truss::Face& face = truss.faces[f];
    const Vector3d normal = face.frame.linear().col(2), z = pose.linear().col(2);
    if (std::abs(normal.dot(pose.translation() - face.frame.translation())) > tolerance) continue;
    if (std::atan2(normal.cross(z).norm(), normal.dot(z)) > tolerance) continue;
    const Vector3d at = face.frame.inverse() * pose.translation();
    if (!contains(face, at.head<2>())) continue;
    const double inside = distance_to_edges(face, at.head<2>());
    if (inside <= farthest) continue;
    farthest = inside;
    const Vector3d x = face.frame.linear().transpose() * pose.linear().col(0);
    best = Foothold{static_cast<int>(f), at.head<2>(), std::atan2(x.y(), x.x())};
  }
  return best;
}

}  // namespace foothold::hyrecro
