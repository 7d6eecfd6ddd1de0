// Contacts to footholds.
#include "hyrecro/place.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

namespace foothold::hyrecro {
namespace {

template <class... Parts>
[[noreturn]] void invalid(const std::string& field, const Parts&... parts) {
  std::ostringstream out;
  out.precision(4);
  (out << ... << parts);
  throw InvalidRequest(field, out.str());
}

double edge_distance(const Polygon& polygon, const Vector2d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    least = std::min(least, geometry::distance(point, polygon[i], polygon[(i + 1) % polygon.size()]));
  return least;
}

// Of a point in the face's plane to the face: 0 on it.
double planar_distance(const truss::Face& face, const Vector2d& point) {
  if (!geometry::contains(face.outline, point)) return edge_distance(face.outline, point);
  for (const Polygon& hole : face.holes)
    if (geometry::contains(hole, point)) return edge_distance(hole, point);
  return 0.0;
}

struct Seen {
  double distance = 0.0;  // m, of the sole's centre to the face
  double tilt = 0.0;      // rad, between the sole's normal and the face's
  Foothold foothold;
};

Seen seen_from(const truss::Truss& truss, int index, const Isometry3d& pose) {
  const truss::Face& face = truss.faces[static_cast<std::size_t>(index)];
  const Isometry3d local = face.frame.inverse() * pose;
  const Vector2d at = local.translation().head<2>();
  const Vector3d normal = local.linear().col(2), forward = local.linear().col(0);
  return {std::hypot(local.translation().z(), planar_distance(face, at)), std::atan2(normal.head<2>().norm(), normal.z()),
          Foothold{index, at, std::atan2(forward.y(), forward.x())}};
}

int face_named(const truss::Truss& truss, const std::string& name, const std::string& field) {
  for (std::size_t i = 0; i < truss.faces.size(); ++i)
    if (truss.faces[i].name == name) return static_cast<int>(i);
  std::string pieces;
  for (const truss::Face& face : truss.faces)
    if (face.name.starts_with(name.substr(0, name.find('/')))) pieces += (pieces.empty() ? "" : ", ") + face.name;
  invalid(field + ".face", "the scene has no face '", name, "'", pieces.empty() ? "" : "; there are " + pieces);
}

double in_degrees(double angle) { return angle * 180.0 / std::numbers::pi; }

}  // namespace

double overhang(const Model& model, const truss::Face& face, const Foothold& foothold) {
  double worst = 0.0;
  for (const Vector2d& corner : footprint(model, foothold)) worst = std::max(worst, planar_distance(face, corner));
  return worst;
}

// The foothold itself if the whole plate lies on its face.
static Foothold on_face(const Model& model, const truss::Truss& truss, const Foothold& at, const std::string& field) {
  const truss::Face& face = truss.faces[static_cast<std::size_t>(at.face)];
  if (!plate_on_face(model, face, at)) {
    const double over = overhang(model, face, at);
    if (over > 0.0) invalid(field + ".position", "the plate reaches ", over, " m over the edge of the face '", face.name, "'");
    invalid(field + ".position", "the plate lies over a gap of the face '", face.name, "'");
  }
  return at;
}

Foothold place_of(const Model& model, const truss::Truss& truss, const Contact& contact, const std::string& field,
                  double tolerance) {
  if (truss.faces.empty()) invalid(field, "the scene has no face to stand on");
  Seen best;
  if (contact.face.empty()) {
    if (const auto at = foothold_at(truss, contact.frame, tolerance)) return on_face(model, truss, *at, field);
    // A tilted foot is told so if it touches a face; else the face that is nearest counts.
    const auto rank = [&](const Seen& seen) { return std::pair(std::max(seen.distance, tolerance), seen.tilt); };
    best = seen_from(truss, 0, contact.frame);
    for (int i = 1; i < static_cast<int>(truss.faces.size()); ++i)
      if (const Seen seen = seen_from(truss, i, contact.frame); rank(seen) < rank(best)) best = seen;
  } else {
    best = seen_from(truss, face_named(truss, contact.face, field), contact.frame);
  }
  const truss::Face& face = truss.faces[static_cast<std::size_t>(best.foothold.face)];
  if (best.distance > tolerance)
    invalid(field + ".position", contact.face.empty() ? "is off every face, the nearest, '" : "is off the face '", face.name, "', ",
            contact.face.empty() ? "is " : "by ", best.distance, " m", contact.face.empty() ? " away" : "");
  if (best.tilt > tolerance)
    invalid(field + ".orientation", "the foot's +Z must be the normal of the face '", face.name, "' and is ", in_degrees(best.tilt),
            " deg off it");
  return on_face(model, truss, best.foothold, field);
}

}  // namespace foothold::hyrecro
