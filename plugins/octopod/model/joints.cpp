// The octopod's coordinates as the interface's posture, and back.
#include <algorithm>
#include <cmath>

#include "foothold/errors.hpp"
#include "octopod/model/body.hpp"

namespace foothold::octopod {

Posture to_posture(const Coordinates& at) {
  Posture out;
  out.base = at.front;
  out.joints.reserve(kJoints);
  for (const Vector3d& joints : at.legs) out.joints.insert(out.joints.end(), joints.data(), joints.data() + 3);
  const Eigen::Matrix3d ball = at.ball.toRotationMatrix();
  const double pitch = std::atan2(-ball(2, 0), std::hypot(ball(0, 0), ball(1, 0)));
  // At a pitch of 90 deg roll and yaw turn about the same line: all of it is told as yaw.
  const bool upright = std::hypot(ball(0, 0), ball(1, 0)) < 1e-9;
  const double roll = upright ? 0.0 : std::atan2(ball(2, 1), ball(2, 2));
  const double yaw = upright ? std::atan2(-ball(0, 1), ball(1, 1)) : std::atan2(ball(1, 0), ball(0, 0));
  out.joints.insert(out.joints.end(), {roll, pitch, yaw});
  return out;
}

Coordinates from_posture(const Posture& posture) {
  if (posture.joints.size() != kJoints)
    throw InvalidRequest("joints",
                         "must hold " + std::to_string(kJoints) + " numbers, holds " + std::to_string(posture.joints.size()));
  Coordinates out;
  out.front = posture.base;
  const double* joint = posture.joints.data();
  for (Vector3d& joints : out.legs) {
    joints = Eigen::Map<const Vector3d>(joint);
    joint += 3;
  }
  out.ball = Eigen::AngleAxisd(joint[2], Vector3d::UnitZ()) * Eigen::AngleAxisd(joint[1], Vector3d::UnitY()) *
             Eigen::AngleAxisd(joint[0], Vector3d::UnitX());
  return out;
}

}  // namespace foothold::octopod
