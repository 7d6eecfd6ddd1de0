// The nine free joints of a single support (paper, section II.C): the supporting leg's six and the swing leg's hip roll, hip pitch
// and knee. The swing leg's hip yaw and both its ankle joints follow, so that the moving sole stays parallel to the ground with a
// given heading. A tenth coordinate carries the heading when the robot turns; it is constant else. Radians. Values; any thread.
#pragma once

#include "bioloid/model/kinematics.hpp"

namespace foothold::bioloid {

using Nine = Eigen::Matrix<double, 9, 1>;

// Free joints of `joints`, in the order: support hip yaw, roll, pitch, knee, ankle pitch, roll; swing hip roll, hip pitch, knee.
Nine free_joints(const Joints& joints, Side support);
// All joints with the swing sole level and turned by `heading` (about Z) against the supporting one; arms as in `model.carrying`.
// False if the three coupled joints have no solution (swing thigh lying in the ground's plane).
bool couple(const Model& model, Side support, const Nine& free, double heading, Joints& joints);
// The heading of the swing sole against the supporting one.
double heading_of(const Model& model, Side support, const Joints& joints);

}  // namespace foothold::bioloid
