#include "hyrecro/check/on_face.hpp"

#include <array>
#include <limits>

#include "hyrecro/check/refusal.hpp"

namespace foothold::hyrecro {
namespace {

using truss::Polygon;
using truss::Vector2d;

const truss::Face& face_of(const truss::Truss& truss, const Contact& contact) {
  for (const truss::Face& face : truss.faces)
    if (face.name == contact.face) return face;
  refuse("foot ", contact.limb, " is placed on face '", contact.face, "', which the scene does not have");
}

// Winding number by the angles that the edges span.
bool winds_round(const Polygon& polygon, const Vector2d& point) {
  double angle = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2d a = polygon[k] - point, b = polygon[(k + 1) % polygon.size()] - point;
    angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::fabs(angle) > 3.0;
}

}  // namespace

// The depth min(hx - |x|, hy - |y|) along the segment is the least of four linear functions: greatest at an end or where two of
// them are equal. If it is nowhere positive, the segment's distance is that of an end to the rectangle or of a corner to the
// segment.
double signed_distance(const Vector2d& half, const Vector2d& p, const Vector2d& q) {
  const Vector2d d = q - p;
  const std::array<std::array<double, 2>, 4> depths{
      {{half.x() - p.x(), -d.x()}, {half.x() + p.x(), d.x()}, {half.y() - p.y(), -d.y()}, {half.y() + p.y(), d.y()}}};
  const auto depth_at = [&](double t) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [at_p, slope] : depths) least = std::min(least, at_p + t * slope);
    return least;
  };
  double deepest = std::max(depth_at(0.0), depth_at(1.0));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double t = (depths[j][0] - depths[i][0]) / (depths[i][1] - depths[j][1]);
      if (t > 0.0 && t < 1.0) deepest = std::max(deepest, depth_at(t));
    }
  if (deepest > 0.0) return -deepest;
  const auto to_rectangle = [&](const Vector2d& point) { return (point.cwiseAbs() - half).cwiseMax(0.0).norm(); };
  double least = std::min(to_rectangle(p), to_rectangle(q));
  for (const double x : {-half.x(), half.x()})
    for (const double y : {-half.y(), half.y()}) least = std::min(least, geometry::distance(Vector2d(x, y), p, q));
  return least;
}

double judge_on_face(const Model& model, const truss::Truss& truss, const Contact& contact) {
  const truss::Face& face = face_of(truss, contact);
  const Isometry3d on_face = face.frame.inverse() * contact.frame;
  const double height = on_face.translation().z();
  if (!(std::fabs(height) <= kPoseTolerance))
    refuse("the sole of foot ", contact.limb, " is ", height, " m above face '", face.name, "'");
  const double tilt = std::atan2(on_face.linear().col(2).head<2>().norm(), on_face.linear()(2, 2));
  if (!(tilt <= kPoseTolerance))
    refuse("the sole of foot ", contact.limb, " is tilted by ", tilt, " rad on face '", face.name, "'");

  const Vector2d half = 0.5 * model.plate.head<2>();
  const Vector2d centre = on_face.translation().head<2>();
  const Vector2d forward = on_face.linear().col(0).head<2>();
  const auto in_plate = [&](const Vector2d& point) {
    const Vector2d r = point - centre;
    return Vector2d(forward.dot(r), forward.x() * r.y() - forward.y() * r.x());
  };
  double least = std::numeric_limits<double>::infinity();
  const auto judge = [&](const Polygon& polygon, const char* what) {
    for (std::size_t k = 0; k < polygon.size(); ++k)
      least = std::min(least, signed_distance(half, in_plate(polygon[k]), in_plate(polygon[(k + 1) % polygon.size()])));
    if (least < -kPoseTolerance)
      refuse("the plate of foot ", contact.limb, " overhangs ", what, " of face '", face.name, "' by ", -least, " m");
  };
  judge(face.outline, "the edge");
  if (!winds_round(face.outline, centre)) refuse("foot ", contact.limb, " stands beside face '", face.name, "'");
  for (const Polygon& hole : face.holes) {
    judge(hole, "a hole");
    if (winds_round(hole, centre)) refuse("foot ", contact.limb, " stands in a hole of face '", face.name, "'");
  }
  return least;
}

}  // namespace foothold::hyrecro
