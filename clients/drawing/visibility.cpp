// Hidden parts by comparing depths over convex overlaps; their union by Clipper, on a fine integer grid.
#include "visibility.hpp"

#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>

#include "painter.hpp"

namespace foothold::drawing {
namespace {

constexpr double kGrid = 1024.0;      // Clipper's units per px
constexpr double kLeastRegion = 0.2;  // px^2; smaller hidden specks come from rounding at shared edges

ClipperLib::Path to_path(const Points& polygon) {
  ClipperLib::Path path;
  for (const Vector3d& p : polygon) path.emplace_back(std::llround(p.x() * kGrid), std::llround(p.y() * kGrid));
  // Clipper unites by the non-zero rule, for which all must turn the same way.
  if (!ClipperLib::Orientation(path)) ClipperLib::ReversePath(path);
  return path;
}

ClipperLib::Paths to_paths(const std::vector<Points>& polygons) {
  ClipperLib::Paths paths;
  for (const Points& polygon : polygons) paths.push_back(to_path(polygon));
  return paths;
}

Region from_paths(const ClipperLib::Paths& paths) {
  Region region;
  for (const ClipperLib::Path& path : paths) {
    if (std::abs(ClipperLib::Area(path)) < kLeastRegion * kGrid * kGrid) continue;
    Points points;
    for (const ClipperLib::IntPoint& p : path)
      points.emplace_back(static_cast<double>(p.X) / kGrid, static_cast<double>(p.Y) / kGrid, 0.0);
    region.push_back(std::move(points));
  }
  return region;
}

Region combine(ClipperLib::ClipType how, const ClipperLib::Paths& subject, const ClipperLib::Paths& clip) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  clipper.AddPaths(clip, ClipperLib::ptClip, true);
  ClipperLib::Paths result;
  clipper.Execute(how, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  ClipperLib::CleanPolygons(result);
  return from_paths(result);
}

}  // namespace

Region unite(const std::vector<Points>& polygons) { return combine(ClipperLib::ctUnion, to_paths(polygons), {}); }

Occluders::Occluders(std::vector<SeenFace> faces) : grid_(flat_bounds(faces), faces.size()) {
  for (SeenFace& face : faces) {
    const auto plane = depth_plane(face.points);
    if (!plane) continue;
    grid_.insert(faces_.size(), flat_bounds(face.points));
    planes_.push_back(*plane);
    faces_.push_back(std::move(face));
  }
}

bool Occluders::hides(const Vector3d& point) const {
  const Vector2d at = point.head<2>();
  const auto near = grid_.near({at, at});
  return std::any_of(near.begin(), near.end(),
                     [&](std::size_t k) { return planes_[k](point) - point.z() > kSameDepth && covers(faces_[k].points, point); });
}

std::vector<std::pair<double, double>> Occluders::hidden(const Vector3d& a, const Vector3d& b) const {
  const Points segment{a, b};
  const Vector3d way = b - a;
  const double length = way.head<2>().squaredNorm();
  std::vector<std::pair<double, double>> stretches;
  if (length < 1e-12) {
    if (hides(a)) stretches.emplace_back(0.0, 1.0);
    return stretches;
  }
  for (const std::size_t k : grid_.near(flat_bounds(segment))) {
    // Clipped as a segment by the face's edges and by the face's plane.
    const Points& face = faces_[k].points;
    double from = 0.0, to = 1.0;
    const auto keep = [&](double at_a, double at_b) {
      if (at_a < 0.0 && at_b < 0.0) to = -1.0;
      if ((at_a < 0.0) == (at_b < 0.0)) return;
      const double t = at_a / (at_a - at_b);
      if (at_a < 0.0)
        from = std::max(from, t);
      else
        to = std::min(to, t);
    };
    const double side = flat_turn(face);
    for (std::size_t i = 0; i < face.size() && from < to; ++i) {
      const Vector3d &p = face[i], &q = face[(i + 1) % face.size()];
      keep(side * flat_cross(p, q, a), side * flat_cross(p, q, b));
    }
    keep(planes_[k](a) - a.z() - kSameDepth, planes_[k](b) - b.z() - kSameDepth);
    if (from < to) stretches.emplace_back(from, to);
  }
  std::sort(stretches.begin(), stretches.end());
  std::vector<std::pair<double, double>> joined;
  constexpr double kGap = 1e-6;
  for (const auto& stretch : stretches) {
    if (!joined.empty() && stretch.first <= joined.back().second + kGap)
      joined.back().second = std::max(joined.back().second, stretch.second);
    else
      joined.push_back(stretch);
  }
  return joined;
}

SplitRegion Occluders::split(const Points& polygon) const {
  SplitRegion result;
  std::vector<Points> hiding;
  const auto plane = depth_plane(polygon);
  if (plane)
    for (const std::size_t k : grid_.near(flat_bounds(polygon))) {
      Points common = overlap(faces_[k].points, polygon);
      if (common.empty()) continue;
      common = clipped(common, [&](const Vector3d& p) { return p.z() - (*plane)(p)-kSameDepth; });
      if (common.size() >= 3 && flat_area(common) > 1e-6) hiding.push_back(std::move(common));
    }
  if (!hiding.empty()) {
    const ClipperLib::Paths whole{to_path(polygon)};
    const ClipperLib::Paths cover = to_paths(hiding);
    result.hidden = combine(ClipperLib::ctIntersection, whole, cover);
    result.visible = combine(ClipperLib::ctDifference, whole, cover);
  }
  if (result.hidden.empty()) {
    result.visible = {polygon};
    result.untouched = true;
  }
  return result;
}

}  // namespace foothold::drawing
