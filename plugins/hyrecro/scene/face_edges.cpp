// Edges in cells along the face's X axis, which is a beam's own.
#include "hyrecro/scene/face_edges.hpp"

namespace foothold::hyrecro {
namespace {

constexpr std::size_t kFew = 16;  // edges that are not worth cells
constexpr int kWide = 4;          // cells that an edge comes into at most without being a wide one

}  // namespace

FaceEdges::FaceEdges(const truss::Face& face) {
  std::vector<Edge> all;
  const auto add = [&](const geometry::Polygon& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) all.push_back({ring[k], ring[k + 1 == ring.size() ? 0 : k + 1]});
  };
  add(face.outline);
  for (const geometry::Polygon& hole : face.holes) add(hole);
  for (const geometry::Vector2d& v : face.outline) bounds_.extend(v);
  if (all.size() <= kFew) {
    begins_ = {0, 0};
    wide_ = std::move(all);
    return;
  }
  const std::size_t cells = all.size() / 4;
  width_ = std::max(1e-9, bounds_.sizes().x() / static_cast<double>(cells));
  begins_.assign(cells + 1, 0);
  std::vector<Edge> narrow;
  for (const Edge& edge : all) {
    const int first = cell(std::min(edge.a.x(), edge.b.x())), last = cell(std::max(edge.a.x(), edge.b.x()));
    if (last - first >= kWide) {
      wide_.push_back(edge);
      continue;
    }
    narrow.push_back(edge);
    for (int c = first; c <= last; ++c) ++begins_[static_cast<std::size_t>(c) + 1];
  }
  for (std::size_t c = 1; c < begins_.size(); ++c) begins_[c] += begins_[c - 1];
  edges_.resize(begins_.back());
  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
  for (const Edge& edge : narrow)
    for (int c = cell(std::min(edge.a.x(), edge.b.x())); c <= cell(std::max(edge.a.x(), edge.b.x())); ++c)
      edges_[next[static_cast<std::size_t>(c)]++] = edge;
}

bool FaceEdges::contains(const geometry::Vector2d& point) const {
  // Crossings of the ray straight up; holes are rings like the outline.
  bool inside = false;
  visit(point.x(), point.x(), [&](const Edge& edge) {
    const geometry::Vector2d &a = edge.a, &b = edge.b;
    if ((a.x() <= point.x()) == (b.x() <= point.x())) return;
    if (a.y() + (point.x() - a.x()) / (b.x() - a.x()) * (b.y() - a.y()) > point.y()) inside = !inside;
  });
  return inside && bounds_.contains(point);
}

}  // namespace foothold::hyrecro
