// The octopod as a tree: module A, the ball joint, module B, eight legs of three joints. Closed both ways. Any thread.
//
// A leg hangs on its shoulder: q1 turns its plane about the module's Z, positive forwards on either side; with q1 = 0 the plane
// looks straight out to the leg's side. In the plane q2 lifts the femur above the module's XY plane and q3 the tibia above the
// femur's line, so q2 = 0, q3 = -90 deg is the right angle: femur level, tibia down.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "octopod/model/model.hpp"

namespace foothold::octopod {

// All coordinates of the robot. Module B's pose follows from A's and the ball joint, so the modules are always joined.
struct Coordinates {
  Isometry3d front = Isometry3d::Identity();                 // module A in the world
  Eigen::Quaterniond ball = Eigen::Quaterniond::Identity();  // module B's orientation seen from A
  std::array<Vector3d, kLegs> legs{};                        // rad, q1 (forth and back), q2 (up and down), q3 (knee)
};

Isometry3d rear(const Model& model, const Coordinates& at);                    // module B in the world
std::array<Isometry3d, 2> modules(const Model& model, const Coordinates& at);  // A and B in the world
Vector3d centre(const Model& model, const Coordinates& at);                    // C, m, world

// A leg's shoulder, knee and foot, m.
struct LegPoints {
  Vector3d shoulder, knee, foot;
};
LegPoints leg(const Model& model, const Coordinates& at, int which);             // world
LegPoints leg_in_module(const Model& model, int which, const Vector3d& joints);  // the module's frame
// How the foot moves with the joints: d foot / d (q1, q2, q3), m/rad, in the module's frame.
Eigen::Matrix3d leg_jacobian(const Model& model, int which, const Vector3d& joints);

// Of the bodies and all links, m, world.
Vector3d centre_of_mass(const Model& model, const Coordinates& at);

// Joints of a leg that bring its foot to `foot` (m, in the module's frame), all branches: the leg's plane looks at the foot or away
// from it, and the knee is up (q3 <= 0) or down. Empty if the point is out of reach by more than rounding (1e-12 m). A foot
// straight under the shoulder leaves q1 free if the coxa is 0: it is 0 then.
using LegSolutions = kinematics::YawLeg::Solutions;
LegSolutions inverse_leg(const Model& model, int which, const Vector3d& foot);
// The branch of the right angle alone: |q1| <= 90 deg, knee up. Empty if it does not reach.
std::optional<Vector3d> natural_leg(const Model& model, int which, const Vector3d& foot);

// To and from the interface's posture: base is module A, joints are A1.q1 .. B4.q3, ball.roll, ball.pitch, ball.yaw (B seen from A
// is Rz(yaw) Ry(pitch) Rx(roll); pitch within 90 deg). Without stance.
Posture to_posture(const Coordinates& at);
// Throws InvalidRequest for a wrong number of joints.
Coordinates from_posture(const Posture& posture);

// Boxes and capsules as they collide, in the world: both bodies, both necks, and per leg femur and tibia without its foot.
std::vector<Shape> shapes(const Model& model, const Coordinates& at);

}  // namespace foothold::octopod
