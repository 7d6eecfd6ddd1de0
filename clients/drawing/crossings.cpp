// Scene faces clipped by the robot's convex bodies, the robot's faces by the scene's, and polygons against polygons.
#include "crossings.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "solids.hpp"

namespace foothold::drawing {
namespace {

constexpr double kBoxShrink = 1e-3;    // of the shortest edge, on each side
constexpr double kRoundShrink = 0.04;  // of the radius
constexpr double kOwnContact = 0.05;   // of the radius or shortest edge: how far off a body its own contact may lie

struct HalfSpace {
  Vector3d normal;
  double offset;  // inside: normal . p <= offset
};

struct Bounds3 {
  Vector3d low, high;
  bool meets(const Bounds3& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

Bounds3 bounds_of(const Points& points, double margin = 0.0) {
  Bounds3 box{points[0], points[0]};
  for (const Vector3d& p : points) box = {box.low.cwiseMin(p), box.high.cwiseMax(p)};
  return {box.low.array() - margin, box.high.array() + margin};
}

bool is_round(const Body& body) { return body.kind == msg::CAPSULE || body.kind == msg::SPHERE; }

// A round body's tangent planes point these ways, in its own frame.
const Points& directions() {
  static const Points all = [] {
    Points points{Vector3d::UnitZ(), -Vector3d::UnitZ()};
    constexpr int kRounds = 16, kHeights = 8;
    for (int h = 1; h < kHeights; ++h)
      for (int r = 0; r < kRounds; ++r) {
        const double down = M_PI * h / kHeights, round = 2.0 * M_PI * r / kRounds;
        points.emplace_back(std::sin(down) * std::cos(round), std::sin(down) * std::sin(round), std::cos(down));
      }
    return points;
  }();
  return all;
}

// The body, a little smaller, as the common part of half spaces. A polygon is none.
std::vector<HalfSpace> solid(const Body& body) {
  std::vector<HalfSpace> sides;
  if (body.kind == msg::BOX) {
    // A plate without thickness has no inside: it comes out empty rather than crossing what it lies on.
    const double less = std::max(kBoxShrink * body.size.minCoeff(), 1e-9);
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-1.0, 1.0}) {
        const Vector3d normal = sign * body.pose.linear().col(axis);
        sides.push_back({normal, normal.dot(body.pose.translation()) + body.size[axis] / 2.0 - less});
      }
  } else if (is_round(body)) {
    const auto [from, to] = axis_ends(body);
    for (const Vector3d& direction : directions()) {
      const Vector3d normal = body.pose.linear() * direction;
      sides.push_back({normal, std::max(normal.dot(from), normal.dot(to)) + body.size.x() * (1.0 - kRoundShrink)});
    }
  }
  return sides;
}

// The surface as convex polygons; a round body's as the polyhedron of rings that has its poles on the axis.
std::vector<Points> surface(const Body& body) {
  std::vector<Points> faces;
  if (body.kind == msg::BOX) return box_faces(body);
  for (const ConvexPiece& piece : body.pieces) faces.push_back(piece.points);
  if (!is_round(body)) return faces;
  constexpr int kRounds = 16, kHeights = 8;
  const double half = body.kind == msg::CAPSULE ? body.size.z() / 2.0 : 0.0;
  const auto at = [&](int ring, int round) {  // rings 0 to kHeights / 2 on the upper end, the rest on the lower
    const bool upper = ring <= kHeights / 2;
    const double down = M_PI * (upper ? ring : ring - 1) / kHeights, angle = 2.0 * M_PI * round / kRounds;
    const Vector3d on_ball(std::sin(down) * std::cos(angle), std::sin(down) * std::sin(angle), std::cos(down));
    return Vector3d(body.pose * (on_ball * body.size.x() + Vector3d(0.0, 0.0, upper ? half : -half)));
  };
  for (int ring = 0; ring <= kHeights; ++ring)
    for (int round = 0; round < kRounds; ++round)
      faces.push_back({at(ring, round), at(ring, round + 1), at(ring + 1, round + 1), at(ring + 1, round)});
  return faces;
}

Points cut_by(Points polygon, const std::vector<HalfSpace>& sides) {
  for (const HalfSpace& side : sides) {
    if (polygon.empty()) break;
    polygon = clipped(polygon, [&](const Vector3d& p) { return side.offset - side.normal.dot(p); });
  }
  return polygon;
}

bool inside(const Vector3d& point, const std::vector<HalfSpace>& sides, double slack = 0.0) {
  return !sides.empty() && std::all_of(sides.begin(), sides.end(),
                                       [&](const HalfSpace& side) { return side.normal.dot(point) <= side.offset + slack; });
}

// What two flat convex polygons have in common: an area if they lie in one plane, else a segment, or nothing.
Points common_part(const Points& a, const Points& b, bool in_one_plane_too) {
  const Vector3d normal = newell(b).normalized();
  double farthest = 0.0, width = 0.0;
  for (const Vector3d& p : a) {
    farthest = std::max(farthest, std::abs(normal.dot(p - b[0])));
    width = std::max(width, (p - a[0]).norm());
  }
  const double thin = 1e-6 * width;
  std::vector<HalfSpace> edges;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const Vector3d outward = (b[(i + 1) % b.size()] - b[i]).cross(normal);
    if (outward.norm() > 0.0) edges.push_back({outward.normalized(), outward.normalized().dot(b[i])});
  }
  if (farthest <= thin) {
    if (!in_one_plane_too) return {};
    Points area = cut_by(a, edges);
    return newell(area).norm() / 2.0 > thin * width ? area : Points{};
  }
  const auto above = [&](const Vector3d& p) { return normal.dot(p - b[0]); };
  Points segment;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vector3d &p = a[i], &q = a[(i + 1) % a.size()];
    if ((above(p) < 0.0) != (above(q) < 0.0)) segment.push_back(p + (q - p) * (above(p) / (above(p) - above(q))));
  }
  // Merely touching the plane with an edge or a corner is no crossing.
  double low = 0.0, high = 0.0;
  for (const Vector3d& p : a) {
    low = std::min(low, above(p));
    high = std::max(high, above(p));
  }
  if (segment.size() != 2 || low > -thin || high < thin) return {};
  segment = cut_by(segment, edges);
  return segment.size() == 2 && (segment[1] - segment[0]).norm() > thin ? segment : Points{};
}

struct Piece {
  const Body* body;
  std::vector<Points> faces;
  std::vector<Bounds3> bounds;  // of each face
  Bounds3 all;
  std::vector<HalfSpace> sides;
};

Piece piece_of(const Body& body) {
  Piece piece{&body, surface(body), {}, {}, solid(body)};
  for (const Points& face : piece.faces) {
    piece.bounds.push_back(bounds_of(face));
    const Bounds3& one = piece.bounds.back();
    piece.all = piece.bounds.size() == 1 ? one : Bounds3{piece.all.low.cwiseMin(one.low), piece.all.high.cwiseMax(one.high)};
  }
  return piece;
}

// Does the body stand there with a contact of its own: is the contact on the body, and the region near the contact and its tangent
// plane?
bool stands(const Piece& robot, const Points& region, const Stance& stance) {
  if (robot.sides.empty()) return false;
  const Body& body = *robot.body;
  const double thickness = is_round(body) ? body.size.x() : body.size.minCoeff();
  const double near = is_round(body) ? 3.0 * body.size.x() : body.size.norm() / 2.0;
  const double sunk = is_round(body) ? 1.5 * body.size.x() : body.size.minCoeff() / 2.0;
  const double slack = thickness * (kOwnContact + (is_round(body) ? kRoundShrink : kBoxShrink));
  const auto is_at = [&](const Foothold& contact) {
    const Vector3d place = contact.frame.translation();
    return inside(place, robot.sides, slack) && std::all_of(region.begin(), region.end(), [&](const Vector3d& p) {
             return (p - place).norm() <= near && std::abs(contact.frame.linear().col(2).dot(p - place)) <= sunk;
           });
  };
  return std::any_of(stance.holding.begin(), stance.holding.end(), is_at) ||
         std::any_of(stance.placed.begin(), stance.placed.end(), is_at);
}

// All regions in which one body of the robot and one piece of the scene meet.
std::vector<Points> regions(const Piece& robot, const Piece& scene, bool scene_is_ground) {
  std::vector<Points> found;
  const auto keep = [&](Points region) {
    if (!region.empty()) found.push_back(std::move(region));
  };
  if (!robot.sides.empty())
    for (std::size_t i = 0; i < scene.faces.size(); ++i)
      if (scene.bounds[i].meets(robot.all)) keep(cut_by(scene.faces[i], robot.sides));
  const bool flat_robot = robot.sides.empty();
  // A body wholly inside a piece of the scene meets no face of it: then its own faces are what is inside.
  if (!scene.sides.empty() && (flat_robot || (found.empty() && inside(middle_of(*robot.body), scene.sides))))
    for (const Points& face : robot.faces) keep(cut_by(face, scene.sides));
  if (flat_robot && scene.sides.empty())
    for (const Points& mine : robot.faces)
      for (std::size_t i = 0; i < scene.faces.size(); ++i)
        if (scene.bounds[i].meets(robot.all)) keep(common_part(mine, scene.faces[i], !scene_is_ground));
  return found;
}

}  // namespace

std::vector<Crossing> crossings(const Plan& plan) {
  std::set<std::string> grounds;
  const auto add_grounds = [&](const std::vector<Foothold>& contacts) {
    for (const Foothold& contact : contacts)
      if (!contact.face.empty()) grounds.insert(contact.face);
  };
  add_grounds(plan.start.contacts);
  add_grounds(plan.goal.contacts);
  for (const Stance& stance : plan.stances) {
    add_grounds(stance.placed);
    add_grounds(stance.holding);
  }
  std::vector<Piece> scene;
  for (const Body& body : plan.scene) scene.push_back(piece_of(body));
  std::vector<Crossing> result;
  for (const Stance& stance : plan.stances)
    for (const Body& body : stance.bodies) {
      const Piece robot = piece_of(body);
      for (const Piece& piece : scene) {
        if (!piece.all.meets(robot.all)) continue;
        for (Points& region : regions(robot, piece, grounds.contains(piece.body->name)))
          if (!stands(robot, region, stance)) result.push_back({stance.index, body.name, piece.body->name, std::move(region)});
      }
    }
  return result;
}

}  // namespace foothold::drawing
