// Boxes, capsules, spheres and polygons as a parallel projection shows them.
#include "solids.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::drawing {
namespace {

constexpr int kArcSteps = 12;       // a half circle's, where it must be a polygon
constexpr double kThinnest = 1e-6;  // px^2; a face of less is seen edge-on

// The half circle round `centre` from `start` (px, relative) on, turning by -90 to +90 deg about the screen's normal.
void add_half_circle(Points& points, const Vector3d& centre, const Vector2d& start) {
  for (int i = 0; i <= kArcSteps; ++i) {
    const double angle = M_PI * i / kArcSteps;
    const Vector2d at = Eigen::Rotation2Dd(angle) * start;
    points.emplace_back(centre.x() + at.x(), centre.y() + at.y(), centre.z());
  }
}

std::vector<bool> every_edge(const Points& points) { return std::vector<bool>(points.size(), true); }

Points convex_hull(Points points) {
  std::sort(points.begin(), points.end(),
            [](const Vector3d& a, const Vector3d& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  const auto turns_left = [](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()) > 0.0;
  };
  Points hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const Vector3d& p : points) {
      while (hull.size() >= begin + 2 && !turns_left(hull[hull.size() - 2], hull.back(), p)) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// The middle section of a capsule: two half discs that face the viewer and the strip between them.
std::vector<SeenFace> round_faces(const Outline& seen, int shade, std::size_t number) {
  const Vector2d along = (seen.to - seen.from).head<2>();
  std::vector<SeenFace> faces;
  const auto add = [&](Points points, std::vector<bool> edges) {
    if (flat_area(points) > kThinnest) faces.push_back({std::move(points), std::move(edges), shade, number});
  };
  if (along.norm() < 1e-6) {
    const Vector3d& nearer = seen.to.z() > seen.from.z() ? seen.to : seen.from;
    Points disc;
    add_half_circle(disc, nearer, {0.0, -seen.cap});
    disc.pop_back();
    add_half_circle(disc, nearer, {0.0, seen.cap});
    disc.pop_back();
    auto edges = every_edge(disc);
    add(std::move(disc), std::move(edges));
    return faces;
  }
  const Vector2d side = Vector2d(-along.y(), along.x()).normalized() * seen.cap;
  const Vector3d aside(side.x(), side.y(), 0.0);
  for (const auto& [centre, start] : {std::pair{seen.from, side}, std::pair{seen.to, Vector2d(-side)}}) {
    Points half;
    add_half_circle(half, centre, start);
    auto edges = every_edge(half);
    edges.back() = false;
    add(std::move(half), std::move(edges));
  }
  add({seen.from + aside, seen.from - aside, seen.to - aside, seen.to + aside}, {false, true, false, true});
  return faces;
}

}  // namespace

int shade_of(const Vector3d& normal) {
  // From the left, before and above in the usual view: of two upright faces at a corner one is darker.
  const Vector3d light = Vector3d(-0.40, -0.58, 0.71).normalized();
  const double bright = std::clamp(0.35 + 0.65 * normal.dot(light), 0.0, 1.0);
  return static_cast<int>(std::lround(bright * (kShades - 1)));
}

std::pair<Vector3d, Vector3d> axis_ends(const Body& body) {
  const Vector3d half = body.kind == msg::CAPSULE ? Vector3d(0.0, 0.0, body.size.z() / 2.0) : Vector3d(0.0, 0.0, 0.0);
  return {body.pose * -half, body.pose * half};
}

Points box_corners(const Body& box) {
  Points corners;
  for (unsigned k = 0; k < 8; ++k) {
    const Vector3d sign((k & 1U) != 0 ? 0.5 : -0.5, (k & 2U) != 0 ? 0.5 : -0.5, (k & 4U) != 0 ? 0.5 : -0.5);
    corners.push_back(box.pose * sign.cwiseProduct(box.size));
  }
  return corners;
}

std::vector<Points> box_faces(const Body& box) {
  static constexpr int kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  const Points corners = box_corners(box);
  std::vector<Points> faces;
  for (const auto& face : kFaces) {
    Points points;
    for (const int k : face) points.push_back(corners[static_cast<std::size_t>(k)]);
    faces.push_back(std::move(points));
  }
  return faces;
}

std::vector<SeenFace> seen_faces(const Body& body, const Projection& projection, std::size_t number) {
  std::vector<SeenFace> faces;
  if (body.kind == msg::POLYGON) {
    for (const ConvexPiece& piece : body.pieces) {
      Points seen = projection(piece.points);
      if (flat_area(seen) <= kThinnest) continue;
      const Vector3d normal = newell(piece.points).normalized();
      const double facing = normal.dot(projection.camera.towards) < 0.0 ? -1.0 : 1.0;
      faces.push_back({std::move(seen), piece.outline, shade_of(facing * normal), number});
    }
    return faces;
  }
  if (body.kind == msg::BOX) {
    // A box without thickness is a plate, seen from both sides: of its two coinciding faces the one that looks here is taken.
    const std::vector<Points> all = box_faces(body);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Vector3d normal = body.pose.linear().col(static_cast<int>(i / 2)) * (i % 2 == 0 ? -1.0 : 1.0);
      if (normal.dot(projection.camera.towards) <= 0.0) continue;
      Points seen = projection(all[i]);
      if (flat_area(seen) <= kThinnest) continue;
      auto edges = every_edge(seen);
      faces.push_back({std::move(seen), std::move(edges), shade_of(normal), number});
    }
    return faces;
  }
  // A round body's visible side is lit like the slope half way between the viewer and straight up.
  const Vector3d lit = (projection.camera.towards + Vector3d::UnitZ() * 0.5).normalized();
  return round_faces(outline(body, projection), shade_of(lit), number);
}

Box2 flat_bounds(const std::vector<SeenFace>& faces) {
  if (faces.empty()) return {Vector2d::Zero(), Vector2d::Zero()};
  Box2 all = flat_bounds(faces[0].points);
  for (const SeenFace& face : faces) {
    const Box2 one = flat_bounds(face.points);
    all = {all.low.cwiseMin(one.low), all.high.cwiseMax(one.high)};
  }
  return all;
}

std::vector<Points> edge_on_pieces(const Body& body, const Projection& projection) {
  std::vector<Points> pieces;
  for (const ConvexPiece& piece : body.pieces) {
    Points seen = projection(piece.points);
    if (flat_area(seen) <= kThinnest) pieces.push_back(std::move(seen));
  }
  return pieces;
}

Outline outline(const Body& body, const Projection& projection) {
  Outline result;
  switch (body.kind) {
    case msg::POLYGON:
      for (const ConvexPiece& piece : body.pieces) result.polygons.push_back(projection(piece.points));
      break;
    case msg::BOX:
      result.polygons.push_back(convex_hull(projection(box_corners(body))));
      break;
    case msg::CAPSULE:
    case msg::SPHERE: {
      const auto [from, to] = axis_ends(body);
      result.round = true;
      result.from = projection(from);
      result.to = projection(to);
      result.cap = body.size.x() * projection.scale;
      break;
    }
  }
  return result;
}

Points bounding_points(const Body& body, const Camera& camera) {
  Points points;
  if (body.kind == msg::BOX) return box_corners(body);
  for (const ConvexPiece& piece : body.pieces) points.insert(points.end(), piece.points.begin(), piece.points.end());
  if (body.kind == msg::POLYGON) return points;
  const auto [from, to] = axis_ends(body);
  for (const Vector3d& end : {from, to})
    for (const Vector3d& way : {camera.right, camera.up})
      for (const double sign : {-1.0, 1.0}) points.push_back(end + sign * body.size.x() * way);
  return points;
}

Vector3d middle_of(const Body& body) {
  if (body.kind != msg::POLYGON) return body.pose.translation();
  Vector3d sum = Vector3d::Zero();
  double weight = 0.0;
  for (const ConvexPiece& piece : body.pieces) {
    sum += mean(piece.points) * static_cast<double>(piece.points.size());
    weight += static_cast<double>(piece.points.size());
  }
  return sum / weight;
}

}  // namespace foothold::drawing
