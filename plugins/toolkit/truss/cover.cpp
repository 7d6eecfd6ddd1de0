// What of a face another solid covers, and what remains of it.
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "geometry/near_boxes.hpp"
#include "geometry/region.hpp"
#include "truss/layout.hpp"

namespace foothold::truss {
namespace {

// A face is covered where a solid fills the space this far above it: solids that touch within it cover, solids that end flush with
// the face do not.
constexpr double kTouch = 1e-6;  // m

using Eigen::AlignedBox3d;

AlignedBox3d bounds_of(const Solid& box) {
  const Vector3d reach = box.pose.linear().cwiseAbs() * box.half;
  return {box.pose.translation() - reach, box.pose.translation() + reach};
}

AlignedBox3d bounds_of(const Face& face) {
  AlignedBox3d bounds;
  for (const Vector2d& v : face.outline) bounds.extend(face.frame * Vector3d(v.x(), v.y(), 0.0));
  return bounds;
}

// The box's section with the plane z = kTouch of `frame`: convex, in the frame's x and y.
Polygon section(const Solid& box, const Isometry3d& frame) {
  const Isometry3d pose = frame.inverse() * box.pose;
  std::array<Vector3d, 8> corner;
  for (std::size_t k = 0; k < 8; ++k)
    corner[k] = pose * Vector3d((k & 1u) ? box.half.x() : -box.half.x(), (k & 2u) ? box.half.y() : -box.half.y(),
                                (k & 4u) ? box.half.z() : -box.half.z());
  Polygon points;
  for (std::size_t a = 0; a < 8; ++a)
    for (const std::size_t bit : {1u, 2u, 4u}) {
      const std::size_t b = a | bit;
      if (b == a || (corner[a].z() < kTouch) == (corner[b].z() < kTouch)) continue;
      const double share = (kTouch - corner[a].z()) / (corner[b].z() - corner[a].z());
      points.push_back((corner[a] + share * (corner[b] - corner[a])).head<2>());
    }
  if (points.size() < 3) return {};
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& p : points) middle += p / static_cast<double>(points.size());
  std::sort(points.begin(), points.end(), [&](const Vector2d& p, const Vector2d& q) {
    return std::atan2(p.y() - middle.y(), p.x() - middle.x()) < std::atan2(q.y() - middle.y(), q.x() - middle.x());
  });
  return points;
}

bool overlap(const Polygon& a, const Polygon& b) {
  Eigen::AlignedBox2d box_a, box_b;
  for (const Vector2d& v : a) box_a.extend(v);
  for (const Vector2d& v : b) box_b.extend(v);
  return box_a.intersects(box_b);
}

Vector2d first_corner(const Polygon& polygon) {
  return *std::min_element(polygon.begin(), polygon.end(),
                           [](const Vector2d& a, const Vector2d& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
}

}  // namespace

void cut_covered(std::vector<Face>& faces, const std::vector<Solid>& solids) {
  std::vector<AlignedBox3d> bounds;  // of all faces, then of the boxes
  std::vector<std::size_t> boxes;
  for (const Face& face : faces) bounds.push_back(bounds_of(face));
  for (std::size_t s = 0; s < solids.size(); ++s)
    if (solids[s].kind == Solid::Kind::kBox) {
      boxes.push_back(s);
      bounds.push_back(bounds_of(solids[s]));
    }
  std::map<std::size_t, std::vector<Polygon>> cutters;
  const auto count = static_cast<int>(faces.size());
  geometry::for_near_pairs(bounds, 2.0 * kTouch, [&](int i, int j) {
    if (i >= count || j < count) return;
    const auto f = static_cast<std::size_t>(i);
    const std::size_t s = boxes[static_cast<std::size_t>(j - count)];
    if (faces[f].solid == static_cast<int>(s)) return;
    Polygon cutter = section(solids[s], faces[f].frame);
    if (cutter.size() >= 3 && overlap(cutter, faces[f].outline)) cutters[f].push_back(std::move(cutter));
  });
  if (cutters.empty()) return;
  std::vector<Face> out;
  out.reserve(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto found = cutters.find(f);
    if (found == cutters.end()) {
      out.push_back(std::move(faces[f]));
      continue;
    }
    std::vector<geometry::Region> pieces = geometry::difference({faces[f].outline, faces[f].holes}, found->second);
    // Numbered along the face's X axis (a beam's own), whatever order the clipping has.
    std::sort(pieces.begin(), pieces.end(), [](const geometry::Region& a, const geometry::Region& b) {
      const Vector2d p = first_corner(a.outline), q = first_corner(b.outline);
      return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y());
    });
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      Face piece = faces[f];
      if (pieces.size() > 1) piece.name += "." + std::to_string(k + 1);
      piece.outline = std::move(pieces[k].outline);
      piece.holes = std::move(pieces[k].holes);
      out.push_back(std::move(piece));
    }
  }
  faces = std::move(out);
}

}  // namespace foothold::truss
