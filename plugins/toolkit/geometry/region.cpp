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

Path to_path(std::span<const Vector2d> polygon) {
  Path path;
  path.reserve(polygon.size());
  for (const Vector2d& v : polygon)
    path.emplace_back(static_cast<cInt>(std::llround(v.x() / kGrid)), static_cast<cInt>(std::llround(v.y() / kGrid)));
  return path;
}

Polygon to_polygon(const Path& path) {
  Polygon polygon;
  polygon.reserve(path.size());
  for (const IntPoint& p : path) polygon.emplace_back(static_cast<double>(p.X) * kGrid, static_cast<double>(p.Y) * kGrid);
  return polygon;
}

Paths to_paths(const Region& region) {
  Paths paths{to_path(region.outline)};
  for (const Polygon& hole : region.holes) paths.push_back(to_path(hole));
  return paths;
}

// Outlines with the holes that they hold directly; islands in holes are regions of their own.
std::vector<Region> to_regions(const PolyTree& tree) {
  std::vector<Region> regions;
  for (const PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
    if (node->IsHole()) continue;
    Region region{to_polygon(node->Contour), {}};
    if (signed_area(region.outline) < kLeastArea) continue;
    for (const PolyNode* child : node->Childs)
      if (std::abs(Area(child->Contour)) * kGrid * kGrid >= kLeastArea) region.holes.push_back(to_polygon(child->Contour));
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
  Clipper clipper(ioStrictlySimple);
  clipper.AddPaths(to_paths(region), ptSubject, true);
  for (const Polygon& cutter : cutters) {
    Path path = to_path(cutter);
    if (!Orientation(path)) ReversePath(path);
    clipper.AddPath(path, ptClip, true);
  }
  PolyTree tree;
  clipper.Execute(ctDifference, tree, pftEvenOdd, pftNonZero);
  return to_regions(tree);
}

std::vector<Region> inset(const Region& region, double distance) {
  ClipperOffset offset(kMitreLimit);
  offset.AddPaths(to_paths(region), jtMiter, etClosedPolygon);
  PolyTree tree;
  offset.Execute(tree, -distance / kGrid);
  return to_regions(tree);
}

}  // namespace foothold::geometry
