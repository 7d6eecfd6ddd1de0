// Beams to boxes and faces.
#include <array>

#include "geometry/triangulation.hpp"
#include "truss/layout.hpp"

namespace foothold::truss {
namespace {

// A side of a box: the box's axes that are the face's normal and X, with their signs.
struct Side {
  const char* name;
  int normal;
  double sign;
  int along;
};
constexpr std::array<Side, 6> kSides{{{"top", 2, 1.0, 0},
                                      {"bottom", 2, -1.0, 0},
                                      {"left", 1, 1.0, 0},
                                      {"right", 1, -1.0, 0},
                                      {"begin", 0, -1.0, 1},
                                      {"end", 0, 1.0, 1}}};

Face side_of(const Solid& box, int solid, const Side& side) {
  const Vector3d normal = side.sign * box.pose.linear().col(side.normal);
  const Vector3d x = box.pose.linear().col(side.along);
  Face face;
  face.name = box.name + "/" + side.name;
  face.solid = solid;
  face.frame = Isometry3d::Identity();
  face.frame.linear() << x, normal.cross(x), normal;
  face.frame.translation() = box.pose.translation() + box.half[side.normal] * normal;
  const double a = box.half[side.along], b = box.half[3 - side.normal - side.along];
  face.outline = {{-a, -b}, {a, -b}, {a, b}, {-a, b}};
  return face;
}

// Twice the vector area (Newell): its direction is the normal that sees the polygon counter-clockwise.
Vector3d newell(const std::vector<Vector3d>& polygon) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) sum += (polygon[k] - polygon[0]).cross(polygon[k + 1] - polygon[0]);
  return sum;
}

Face face_of(const Plate& plate) {
  const Vector3d area = newell(plate.polygon);
  const bool counter_clockwise = area.dot(plate.normal) > 0.0;
  const Vector3d normal = (counter_clockwise ? area : -area).normalized();
  Face face;
  face.name = plate.name;
  face.frame = Isometry3d::Identity();
  face.frame.linear() << axis_in(normal), normal.cross(axis_in(normal)), normal;
  Vector3d centre = Vector3d::Zero();
  for (const Vector3d& v : plate.polygon) centre += v / static_cast<double>(plate.polygon.size());
  face.frame.translation() = centre;
  const Isometry3d into = face.frame.inverse();
  for (const Vector3d& v : plate.polygon) face.outline.push_back((into * v).head<2>());
  if (!counter_clockwise) std::reverse(face.outline.begin(), face.outline.end());
  return face;
}

}  // namespace

Vector3d default_up(const Vector3d& along) {
  return std::abs(along.normalized().z()) < 0.9 ? Vector3d::UnitZ() : Vector3d::UnitX();
}

Solid box_of(const Beam& beam) {
  const Vector3d x = (beam.to - beam.from).normalized();
  const Vector3d z = (beam.up - beam.up.dot(x) * x).normalized();
  Solid box;
  box.name = beam.name;
  box.pose.linear() << x, z.cross(x), z;
  box.pose.translation() = 0.5 * (beam.from + beam.to);
  box.half = 0.5 * Vector3d((beam.to - beam.from).norm(), beam.width, beam.height);
  return box;
}

Truss build(const Layout& layout) {
  Truss truss;
  truss.description = layout.description;
  truss.faces.reserve(6 * layout.beams.size() + layout.plates.size());
  for (const Beam& beam : layout.beams) {
    const int solid = static_cast<int>(truss.solids.size());
    truss.solids.push_back(box_of(beam));
    for (const Side& side : kSides) truss.faces.push_back(side_of(truss.solids.back(), solid, side));
  }
  for (const Plate& plate : layout.plates) {
    truss.faces.push_back(face_of(plate));
    const Face& face = truss.faces.back();
    for (Polygon& piece : geometry::convex_pieces(face.outline))
      truss.solids.push_back({plate.name, Solid::Kind::kPolygon, face.frame, Vector3d::Zero(), std::move(piece)});
  }
  cut_covered(truss.faces, truss.solids);
  return truss;
}

}  // namespace foothold::truss
