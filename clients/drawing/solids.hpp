// Bodies as faces and outlines on the screen.
#pragma once

#include <cstdint>

#include "camera.hpp"
#include "plan.hpp"

namespace foothold::drawing {

// A flat convex part of a body as seen: what is painted, and what hides other things.
struct SeenFace {
  Points points;              // screen
  std::vector<bool> outline;  // edge i is an edge of the body, not of a cut
  int shade = 0;              // 0 dark to kShades - 1 light
  std::size_t body = 0;       // whose it is
};
inline constexpr int kShades = 16;

// Brightness of a surface with this unit normal, lit slantwise so that gentle slopes differ too.
int shade_of(const Vector3d& normal);

// The faces of a body that look towards the viewer. A polygon is seen from both sides. A capsule or sphere is its middle section:
// the flat figure through its axis, facing the viewer, that has the outline of the whole; it lies inside the body, so that whatever
// does not reach into the body is before or behind both alike. Faces seen edge-on are left out.
std::vector<SeenFace> seen_faces(const Body& body, const Projection& projection, std::size_t number);
// Of all faces together; without any, a point.
Box2 flat_bounds(const std::vector<SeenFace>& faces);
// Pieces of a polygon that are seen edge-on: only their edges are.
std::vector<Points> edge_on_pieces(const Body& body, const Projection& projection);

// A body's silhouette: one polygon per piece. `cap` is the half width of a capsule or sphere, px, whose ends are `from` and `to`.
struct Outline {
  std::vector<Points> polygons;
  bool round = false;
  Vector3d from = Vector3d::Zero(), to = Vector3d::Zero();
  double cap = 0.0;
};
Outline outline(const Body& body, const Projection& projection);

// The centres of a capsule's or sphere's two ends, in the world.
std::pair<Vector3d, Vector3d> axis_ends(const Body& body);
// The eight corners of a box: corner k lies on the positive side of axis i if bit i of k is set.
Points box_corners(const Body& box);
// The six faces of a box, counter-clockwise from outside.
std::vector<Points> box_faces(const Body& box);
// World points that bound the body on the camera's picture.
Points bounding_points(const Body& body, const Camera& camera);
Vector3d middle_of(const Body& body);

}  // namespace foothold::drawing
