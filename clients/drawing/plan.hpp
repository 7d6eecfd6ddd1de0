// A plan as geometry: the messages, checked and turned into Eigen's types. What comes out of here is finite and well formed.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "foothold/drawing/draw.hpp"
#include "polygon.hpp"

namespace foothold::drawing {

using Eigen::Isometry3d;

// A body of the robot or a piece of the scene, in the world; fields as msg::Shape has them, with the pieces of a polygon.
struct Body {
  msg::ShapeKind kind = msg::BOX;
  std::string name;
  Isometry3d pose = Isometry3d::Identity();  // of BOX, CAPSULE, SPHERE
  Vector3d size = Vector3d::Zero();
  std::vector<ConvexPiece> pieces;  // of POLYGON
};

struct Foothold {
  std::string limb;
  std::string face;
  Isometry3d frame = Isometry3d::Identity();
};

// The robot after one step.
struct Stance {
  std::uint32_t index = 0;
  std::string label;
  std::vector<Foothold> placed;
  std::vector<Foothold> holding;
  Points base_way;  // through the step's motion to the base after it: one point at least
  std::vector<Body> bodies;
};

// Start or goal.
struct Mark {
  std::vector<Foothold> contacts;
  std::optional<Vector3d> base;
  bool empty() const { return contacts.empty() && !base; }
};

struct Plan {
  std::vector<Body> scene;
  std::vector<Stance> stances;  // the chosen ones
  Mark start, goal;
};

// Throws InvalidDrawing, see draw_svg().
Plan checked_plan(const Drawing& drawing, const DrawOptions& options);

}  // namespace foothold::drawing
