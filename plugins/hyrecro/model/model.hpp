// HyReCRo's numbers, as config/robots/hyrecro.yaml gives them.
#pragma once

#include "foothold/model.hpp"
#include "foothold/types.hpp"
#include "kinematics/planar_mechanism.hpp"

namespace foothold::hyrecro {

struct Model {
  kinematics::PlanarMechanism mechanism{0.04, 0.04, 0.19, 0.25};  // of which each leg has two
  double core = 0.0;          // m, h: what a leg's length lacks to y1 + y2 (both mechanisms share the leg's core)
  double hip_distance = 0.0;  // m, t: between the two hip axes
  double ankle_height = 0.0;  // m, a: from the sole to the ankle pin
  double hip_drop = 0.0;      // m, a2: from the upper pin to the middle of the hip plate
  Vector3d plate =
      Vector3d::Zero();  // m, full edges of a gripper's plate: X (forward), Y (across), Z (thickness) of a foot's frame
  Vector3d hip_plate = Vector3d::Zero();  // m, full edges: along the line between the hip axes, across, thickness
  double leg_radius = 0.0;                // m, of a leg's capsule
  double leg_begin = 0.0;                 // m, from the ankle pin to where the leg's capsule begins
  double skin = 0.0;                      // m, the plates' lowest layer that counts as contact, not as collision
  double actuator_speed = 0.0;            // m/s, of a linear actuator, at most
  double hip_speed = 0.0;                 // rad/s, of a hip joint, at most
  double grip_time = 0.0;                 // s, to let go of one surface and hold on to the next

  // Throws InvalidModel.
  static Model from_model(const RobotModel& model);
};

}  // namespace foothold::hyrecro
