// Hex-piderix as a chain: thorax and six legs, closed both ways (in place of the paper's eqs. 2 to 7, which are garbled in print).
// Metres and radians. Values; any thread.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hexpiderix/model/model.hpp"

namespace foothold::hexpiderix {

using Joints = std::array<Vector3d, kLegs>;  // q1, q2, q3 of each leg, rad

struct Coordinates {
  Isometry3d thorax = Isometry3d::Identity();  // in the world
  Joints legs{};
};

// A leg's coxa axis, femur axis, knee and foot in the thorax' frame.
struct LegPoints {
  Vector3d coxa, hip, knee, foot;
};
LegPoints leg_points(const Model& model, std::size_t leg, const Vector3d& joints);

// Where the tibia ends and the toe begins, in the thorax' frame.
Vector3d ankle_of(const Model& model, const LegPoints& points);

// Where a leg's foot is when the robot stands: joints 0 but the tibia vertical. In the thorax' frame.
Vector3d standing_foot(const Model& model, std::size_t leg);
// The joints of the standing robot, and of a leg that swings with its foot `lift` (m) above its standing place.
Vector3d standing_joints();
Vector3d swinging_joints(const Model& model, std::size_t leg, double lift);

bool within_limits(const Model& model, const Vector3d& joints);
// Joints within their limits that bring a leg's foot to `foot` (thorax' frame): knee up before knee down, in front before behind.
// Empty if there are none.
std::optional<Vector3d> reach(const Model& model, std::size_t leg, const Vector3d& foot);

// By composed bodies (paper, section 3), in the thorax' frame: thorax, servos at the joints, brackets at mid length.
Vector3d centre_of_mass(const Model& model, const Joints& legs);

// To and from the interface's posture: base is the thorax.
Posture to_posture(const Coordinates& at);         // without stance
Coordinates from_posture(const Posture& posture);  // Precondition: 18 joints.
std::vector<Shape> shapes(const Model& model, const Coordinates& at);

}  // namespace foothold::hexpiderix
