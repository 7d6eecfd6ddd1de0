// Hex-piderix' numbers, as config/robots/hexpiderix.yaml gives them, and the names of its limbs and joints.
//
// The thorax' frame: origin in its middle at the height of the coxa axes, X towards leg 1, Z up. Legs 1 to 6 stand at 0, 60, ...
// 300 degrees (paper, Figure 1). Triad 1 is legs 1, 3, 5; triad 2 legs 2, 4, 6.
#pragma once

#include <array>
#include <bitset>

#include "foothold/model.hpp"
#include "foothold/types.hpp"
#include "kinematics/planar_mechanism.hpp"
#include "kinematics/yaw_leg.hpp"

namespace foothold::hexpiderix {

inline constexpr std::size_t kLegs = 6;
inline constexpr const char* kLimbs = "L1|L2|L3|L4|L5|L6";
inline constexpr const char* kJointNames =
    "L1.q1|L1.q2|L1.q3|L2.q1|L2.q2|L2.q3|L3.q1|L3.q2|L3.q3|L4.q1|L4.q2|L4.q3|L5.q1|L5.q2|L5.q3|L6.q1|L6.q2|L6.q3";

// A set of legs; bit 0 is leg 1.
using Legs = std::bitset<kLegs>;
inline constexpr Legs kTriad1{0b010101}, kTriad2{0b101010};

struct Model {
  double thorax_radius = 0.0;                      // m, a1: from the thorax' middle to the coxa axes
  double thorax_width = 0.0, thorax_height = 0.0;  // m, of the body
  kinematics::YawLeg leg;                          // a2, d2, a3, a4
  double leg_radius = 0.0;                         // m, of the capsules round femur and tibia
  double toe = 0.0;                                // m, of a tibia's end that is no collision body
  double lift = 0.0;                               // m, of a swing leg's foot above its place in the standing robot
  std::array<kinematics::Interval, 3> limits;      // rad, of q1, q2, q3
  double joint_speed = 0.0;                        // rad/s, at most
  double thorax_mass = 0.0, femur_mass = 0.0, tibia_mass = 0.0, servo_mass = 0.0;  // kg

  double mass() const;
  // m, of the coxa axes over the ground with all joints 0 but the tibiae vertical: that is how the robot stands.
  double height() const { return leg.drop + leg.tibia; }

  // Throws InvalidModel.
  static Model from_model(const RobotModel& model);
};

}  // namespace foothold::hexpiderix
