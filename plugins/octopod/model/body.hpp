// The octopod as a tree: module A, the ball joint, module B, eight legs of three joints. Closed both ways. Any thread.
#pragma once

#include <array>
#include <vector>

#include "octopod/model/model.hpp"

namespace foothold::octopod {

// All coordinates of the robot. Module B's pose follows from A's and the ball joint, so the modules are always joined.
struct Coordinates {
  Isometry3d front = Isometry3d::Identity();                 // module A in the world
  Eigen::Quaterniond ball = Eigen::Quaterniond::Identity();  // module B's orientation seen from A
  std::array<Vector3d, kLegs> legs{};                        // rad, q1 (forth and back), q2 (up and down), q3 (knee)
};

Isometry3d rear(const Model& model, const Coordinates& at);  // module B in the world
Vector3d centre(const Model& model, const Coordinates& at);  // C, m, world
// A leg's shoulder, knee and foot, m, world.
struct LegPoints {
  Vector3d shoulder, knee, foot;
};
LegPoints leg(const Model& model, const Coordinates& at, int which);
Vector3d centre_of_mass(const Model& model, const Coordinates& at);  // m, world

// Joints of a leg that bring its foot to `foot` (m, in the module's frame), knee up or down; empty if the point is out of reach.
// With coxa 0 a foot straight under the shoulder leaves q1 free: it is 0 then.
struct LegSolutions {
  std::array<Vector3d, 4> joints{};
  int count = 0;
};
LegSolutions inverse_leg(const Model& model, int which, const Vector3d& foot);

// To and from the interface's posture: base is module A, joints are A1.q1 .. B4.q3, ball.roll, ball.pitch, ball.yaw (ZYX).
Posture to_posture(const Model& model, const Coordinates& at);         // without stance
Coordinates from_posture(const Posture& posture);                      // throws InvalidRequest for a wrong number of joints
std::vector<Shape> shapes(const Model& model, const Coordinates& at);  // boxes and capsules, as they collide

}  // namespace foothold::octopod
