// A scene made ready, and how it is drawn.
#include "hyrecro/scene/prepared.hpp"

#include <utility>

namespace foothold::hyrecro {
namespace {

// Cut through the middle of a hole until none is left.
std::vector<Polygon> without_holes(const Region& region) {
  if (region.holes.empty()) return {region.outline};
  Eigen::AlignedBox2d whole, hole;
  for (const Vector2d& v : region.outline) whole.extend(v);
  for (const Vector2d& v : region.holes.front()) hole.extend(v);
  const double x = hole.center().x();
  const Vector2d low = whole.min() - Vector2d::Ones(), high = whole.max() + Vector2d::Ones();
  const Polygon left{low, {x, low.y()}, {x, high.y()}, {low.x(), high.y()}};
  const Polygon right{{x, low.y()}, {high.x(), low.y()}, high, {x, high.y()}};
  std::vector<Polygon> pieces;
  for (const Polygon& half : {left, right})
    for (const Region& part : geometry::difference(region, std::span(&half, 1)))
      for (Polygon& piece : without_holes(part)) pieces.push_back(std::move(piece));
  return pieces;
}

}  // namespace

PreparedTruss::PreparedTruss(const Model& model, truss::Truss given, const SamplingOptions& options, double least)
    : truss(std::move(given)), obstacles(truss), transitions(model, truss, options), clearance(least) {
  if (transitions.all().size() > kLarge) portals.emplace(transitions, truss.faces.size());
}

std::vector<Shape> PreparedTruss::shapes() const {
  std::vector<Shape> shapes;
  for (const truss::Solid& solid : truss.solids)
    if (solid.kind == truss::Solid::Kind::kBox) shapes.push_back({Shape::Kind::kBox, solid.name, solid.pose, 2.0 * solid.half, {}});
  // The faces of beams are the boxes'; a face drawn twice would hide itself.
  for (const truss::Face& face : truss.faces) {
    if (face.solid >= 0) continue;
    for (const Polygon& piece : without_holes({face.outline, face.holes})) {
      Shape shape{Shape::Kind::kPolygon, face.name, Isometry3d::Identity(), Vector3d::Zero(), {}};
      for (const Vector2d& v : piece) shape.vertices.push_back(face.frame * Vector3d(v.x(), v.y(), 0.0));
      shapes.push_back(std::move(shape));
    }
  }
  return shapes;
}

}  // namespace foothold::hyrecro
