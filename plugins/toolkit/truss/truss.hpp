// Scenes for robots that climb trusses: beams and faces. A face is what a gripper can hold on to, a solid is what collides.
//
//   kind: truss
//   description: two crossed beams            # for people; may be left out
//   beams:                                    # each a bar of constant profile round its axis
//     - {name: long, from: [0, 0, 0], to: [2, 0, 0], profile: {width: 0.15, height: 0.15}, up: [0, 0, 1]}   # m; `up`: where the
//     height points
//   faces:                                    # besides beams, or instead of them: plates without thickness
//     - {name: wall, polygon: [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]], normal: [0, -1, 0]}
//
// A beam gives six faces (<beam>/top, bottom, left, right, begin, end). Where another solid covers a part of a face, that part is
// cut out of it, so a face may have holes or fall into pieces (<beam>/top.1, .2).
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "geometry/axis.hpp"
#include "geometry/polygon.hpp"

namespace foothold::truss {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using geometry::axis_in;
using geometry::Polygon;
using geometry::Vector2d;

// A plane part of the surface. Immutable after reading.
struct Face {
  std::string name;
  int solid = -1;              // index of the solid that it bounds; -1: a face given by itself
  Isometry3d frame;            // world from face: origin in the plane, +Z is the unit normal out of the surface
  Polygon outline;             // in the face's frame (x, y), m; simple, counter-clockwise
  std::vector<Polygon> holes;  // clockwise, inside the outline
};

// What robots collide with: a solid box (a beam), or a plane polygon without thickness (a given face, a triangle's patch of a
// mesh).
struct Solid {
  enum class Kind { kBox, kPolygon };
  std::string name;
  Kind kind = Kind::kBox;
  Isometry3d pose = Isometry3d::Identity();  // kBox: centre and axes; kPolygon: frame whose z = 0 plane holds it
  Vector3d half = Vector3d::Zero();          // kBox: half edges, m
  Polygon polygon;                           // kPolygon: convex, counter-clockwise, in `pose`'s x and y
};

struct Truss {
  std::string description;
  std::vector<Face> faces;
  std::vector<Solid> solids;
};

// Reads .yaml as above; refuses unknown keys, names given twice, numbers that are not finite, beams of no length or profile, `up`
// along the beam, faces that are not planar (1e-6 m) or not simple or of no area or of more than 1000 vertices, normals that are
// not of unit length (1e-6) or not perpendicular to the face. Throws InvalidScene whose field is a path such as
// "faces[2].polygon[1]" and whose message begins with the line. Any thread.
Truss read_truss(const std::string& path);
// `text` is what the file would hold.
Truss parse_truss(const std::string& text);

// STL, OBJ or PLY (m): coplanar triangles (1e-6 m) that share edges become one face ("face 1" and so on, by their first triangles);
// the faces' convex pieces are the solids. Refused are files that are none, no triangles, degenerate ones, edges of more than two,
// neighbours that disagree about the outer side. Throws InvalidScene whose field is such as "triangles[3]".
Truss read_mesh(const std::string& path);

}  // namespace foothold::truss
