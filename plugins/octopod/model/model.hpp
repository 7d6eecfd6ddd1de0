// The octopod's numbers, as config/robots/octopod.yaml gives them, and the names of its joints and limbs.
//
// Two equal modules, A in front and B behind, joined at C by an actuated ball joint. A module's frame: origin in the middle of its
// body, X along its axis, Z up out of its back. A looks along the robot's axis, so C lies at -L on A's X axis and at +L on B's
// (L: paper, eq. 5). Four legs to a module, at the body's corners: 1 front left, 2 front right, 3 rear left, 4 rear right.
#pragma once

#include <array>
#include <string>

#include "foothold/model.hpp"
#include "foothold/types.hpp"
#include "kinematics/yaw_leg.hpp"

namespace foothold::octopod {

inline constexpr int kLegs = 8;        // 0..3 module A's, 4..7 module B's
inline constexpr int kLegJoints = 24;  // q1, q2, q3 of each leg
inline constexpr int kJoints = 27;     // the legs' and the ball joint's three
inline constexpr const char* kLimbs = "A1|A2|A3|A4|B1|B2|B3|B4";
inline constexpr const char* kJointNames =
    "A1.q1|A1.q2|A1.q3|A2.q1|A2.q2|A2.q3|A3.q1|A3.q2|A3.q3|A4.q1|A4.q2|A4.q3|"
    "B1.q1|B1.q2|B1.q3|B2.q1|B2.q2|B2.q3|B3.q1|B3.q2|B3.q3|B4.q1|B4.q2|B4.q3|ball.roll|ball.pitch|ball.yaw";
std::string limb(int leg);                                            // "A1" to "B4"
constexpr int module_of(int leg) { return leg / 4; }                  // 0: A, 1: B
constexpr double side(int leg) { return leg % 2 == 0 ? 1.0 : -1.0; }  // +1: left, -1: right

struct Model {
  double coxa = 0.0, femur = 0.0, tibia = 0.0;                 // m, lengths of a leg's links
  Vector3d body = Vector3d::Zero();                            // m, full edges of a module's body (Lc along X)
  double neck = 0.0;                                           // m, l: from the body's end to C
  std::array<Vector3d, 4> shoulders;                           // m, of a module's legs, in its frame
  double height = 0.0;                                         // m, b: C above its node along the node's normal
  double body_mass = 0.0, femur_mass = 0.0, tibia_mass = 0.0;  // kg, of one each; link centres of mass lie at mid length
  double leg_radius = 0.0, neck_radius = 0.0;                  // m, of the capsules for collisions
  double foot = 0.0;                                           // m, the last of the tibia, which may touch the ground
  double joint_speed = 0.0;                                    // rad/s, at most, of legs and ball joint, for the motions' times
  double foot_speed = 0.0;                                     // m/s, of a swinging foot and of the bodies, at most

  double arm() const { return neck + body.x() / 2; }     // m, L of the paper: from C to the middle of a body
  double reach() const { return coxa + femur + tibia; }  // m, R of the paper: a stretched leg
  kinematics::YawLeg leg() const { return {.coxa = coxa, .drop = 0.0, .femur = femur, .tibia = tibia}; }
  double mass() const { return 2 * body_mass + kLegs * (femur_mass + tibia_mass); }

  // Throws InvalidModel: what is missing, in another unit, negative, or zero though it must not be.
  static Model from_model(const RobotModel& file);
};

}  // namespace foothold::octopod
