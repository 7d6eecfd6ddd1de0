// Regions by polyclipping.
#include "geometry/region.hpp"

#include <cmath>
#include <numeric>
#include <polyclipping/clipper.hpp>

namespace foothold::geometry {
namespace {

using namespace ClipperLib;

constexpr double kGrid = 1e-8;        // m
constexpr double kLeastArea = 1e-10;  // m^2: smaller pieces are rounding
constexpr double kMitreLimit = 20.0;

// The library sweeps along Y and is slow where many edges share a Y; so what is long along X lies down for it.
struct Turn {
  bool quarter = false;
  IntPoint in(const Vector2d& v) const {
    const auto x = static_cast<cInt>(std::llround(v.x() / kGrid)), y = static_cast<cInt>(std::llround(v.y() / kGrid));
    return quarter ? IntPoint(-y, x) : IntPoint(x, y);
  }
  Vector2d out(const IntPoint& p) const {
    const double x = static_cast<double>(p.X) * kGrid, y = static_cast<double>(p.Y) * kGrid;
    return quarter ? Vector2d(y, -x) : Vector2d(x, y);
  }
};

Turn turn_for(const Region& region) {
  Vector2d low = region.outline.front(), high = low;
  for (const Vector2d& v : region.outline) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return {(high - low).x() > (high - low).y()};
}

Path to_path(std::span<const Vector2d> polygon, const Turn& turn) {
  Path path;
  path.reserve(polygon.size());
  for (const Vector2d& v : polygon) path.push_back(turn.in(v));
  return path;
}

Polygon to_polygon(const Path& path, const Turn& turn) {
  Polygon polygon;
  polygon.reserve(path.size());
  for (const IntPoint& p : path) polygon.push_back(turn.out(p));
  return polygon;
}

Paths to_paths(const Region& region, const Turn& turn) {
  Paths paths{to_path(region.outline, turn)};
  for (const Polygon& hole : region.holes) paths.push_back(to_path(hole, turn));
  return paths;
}

// Outlines with the holes that they hold directly; islands in holes are regions of their own.
std::vector<Region> to_regions(const PolyTree& tree, const Turn& turn) {
  std::vector<Region> regions;
  for (const PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
    if (node->IsHole()) continue;
    Region region{to_polygon(node->Contour, turn), {}};
    if (signed_area(region.outline) < kLeastArea) continue;
    for (const PolyNode* child : node->Childs)
      if (std::abs(Area(child->Contour)) * kGrid * kGrid >= kLeastArea) region.holes.push_back(to_polygon(child->Contour, turn));
    regions.push_back(std::move(region));
  }
  return regions;
}

}  // namespace

double area(const Region& region) {
  return std::accumulate(region.holes.begin(), region.holes.end(), signed_area(region.outline),
                         [](double sum, const Polygon& hole) { return sum - std::abs(signed_area(hole)); });
}

bool contains(const Region& region, const Vector2d& point) {
  if (!contains(std::span(region.outline), point)) return false;
  for (const Polygon& hole : region.holes)
    if (contains(std::span(hole), point)) return false;
  return true;
}

std::vector<Region> difference(const Region& region, std::span<const Polygon> cutters) {
  if (cutters.empty()) return {region};
  const Turn turn = turn_for(region);
  Clipper clipper(ioStrictlySimple);
  clipper.AddPaths(to_paths(region, turn), ptSubject, true);
  for (const Polygon& cutter : cutters) {
    Path path = to_path(cutter, turn);
    if (!Orientation(path)) ReversePath(path);
    clipper.AddPath(path, ptClip, true);
  }
  PolyTree tree;
  clipper.Execute(ctDifference, tree, pftEvenOdd, pftNonZero);
  return to_regions(tree, turn);
}

std::vector<Region> inset(const Region& region, double distance) {
  const Turn turn = turn_for(region);
  ClipperOffset offset(kMitreLimit);
  offset.AddPaths(to_paths(region, turn), jtMiter, etClosedPolygon);
  PolyTree tree;
  offset.Execute(tree, -distance / kGrid);
  return to_regions(tree, turn);
}

}  // namespace foothold::geometry
