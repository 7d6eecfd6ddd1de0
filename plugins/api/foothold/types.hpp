// The domain types of a planner: what it is asked, what it emits. Values only; SI units, radians, right-handed world frame.
//
// A contact's frame has +Z out of the surface and +X along the foot's forward axis. Where a robot's paper has another convention,
// its plugin converts, and nobody else.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace foothold {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// A limb that holds on a surface. `face` is the surface's name where the scene names it, else empty.
struct Contact {
  std::string limb;
  Isometry3d frame = Isometry3d::Identity();
  std::string face;
};

// All that is known of a robot that stands still: base pose, joints (in the order of PlannerInfo::joints), contacts that hold.
struct Posture {
  Isometry3d base = Isometry3d::Identity();
  std::vector<double> joints;
  std::vector<Contact> stance;
};

// Where a robot is or shall be, as the client gave it. What is empty was not given; a planner that needs it throws
// InvalidRequest with the field's name ("goal.base").
struct Placement {
  std::vector<Contact> contacts;
  std::optional<Isometry3d> base;
  bool any_orientation = false;  // of `base`: only its position counts
  std::vector<double> joints;
};

// A point of the motion between two postures. `time` in seconds from the step's begin.
struct MotionPoint {
  double time = 0.0;
  Isometry3d base = Isometry3d::Identity();
  std::vector<double> joints;
};

// A named figure with the least value that the checker demands (margins), or the bound that it is compared with (figures).
struct Margin {
  std::string name;
  double value = 0.0;
  double least = 0.0;
  std::string unit;
};

struct Attribute {
  std::string name;
  std::string value;
};

// A body of the robot or a piece of the scene, in the world: what collides is what is drawn.
struct Shape {
  enum class Kind : std::uint32_t { kBox, kCapsule, kSphere, kPolygon };
  Kind kind = Kind::kBox;
  std::string body;  // its name, for people
  Isometry3d pose = Isometry3d::Identity();
  Vector3d size = Vector3d::Zero();  // box: full edges; capsule: x radius, z axis length between centres; sphere: x radius
  std::vector<Vector3d> vertices;    // polygon: planar, in order, in the world, first vertex not repeated
};

// Footholds placed together, the posture after them, and the motion that leads there from the posture before.
struct Step {
  std::string label;                  // for people, one line
  std::vector<Contact> placed;        // what this step places
  Posture after;                      // its stance includes `placed`
  std::vector<MotionPoint> motion;    // empty: none is given
  std::vector<Attribute> attributes;  // the robot's own, such as the number of a configuration
  double cost = 0.0;                  // of the plan up to and with this step, in PlanReport::cost_unit
};

// What check() says of a step. A refusal names the reason in a sentence with the values; `margins` travel with the step.
struct StepVerdict {
  bool accepted = false;
  std::string reason;
  std::vector<Margin> margins;
};

// One request, validated against the parameter schema; `start` and `goal` are for the planner to judge.
struct Request {
  std::string unit;  // which individual, for logs
  Placement start;
  Placement goal;
  double budget = 0.0;  // s left when plan() begins; the server enforces it whatever the plugin does
  std::uint64_t seed = 0;
};

}  // namespace foothold
