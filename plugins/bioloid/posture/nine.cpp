// The three coupled joints in closed form: the swing foot's heading and level fix its x axis f in the torso's frame, and
// f = Rz(yaw) (cos t, sin roll sin t, -cos roll sin t) with t the foot's whole pitch.
#include "bioloid/posture/nine.hpp"

#include <cmath>

namespace foothold::bioloid {
namespace {

using Eigen::Matrix3d;

Matrix3d sole_turn(const Model& model, Side side, const Joints& joints) { return sole_in_torso(model, side, joints).linear(); }

int joint(Side side, std::size_t k) { return static_cast<int>(leg_joint(side, k)); }

}  // namespace

Nine free_joints(const Joints& joints, Side support) {
  Nine out;
  for (std::size_t k = 0; k < kLegJoints; ++k) out[static_cast<int>(k)] = joints[joint(support, k)];
  for (std::size_t k = 1; k < 4; ++k) out[static_cast<int>(k + 5)] = joints[joint(other(support), k)];
  return out;
}

bool couple(const Model& model, Side support, const Nine& free, double heading, Joints& joints) {
  const Side swing = other(support);
  joints = model.carrying;
  for (std::size_t k = 0; k < kLegJoints; ++k) joints[joint(support, k)] = free[static_cast<int>(k)];
  for (std::size_t k = 1; k < 4; ++k) joints[joint(swing, k)] = free[static_cast<int>(k + 5)];

  const Matrix3d wanted = sole_turn(model, support, joints) * Eigen::AngleAxisd(heading, Vector3d::UnitZ()).toRotationMatrix();
  const Vector3d f = wanted.col(0);
  const auto sign = [&](std::size_t k) { return model.sign(swing, k); };
  const double roll = sign(1) * joints[joint(swing, 1)], cosine = std::cos(roll), sine = std::sin(roll);
  const double sine_t = -f.z() / cosine;
  if (!(std::abs(sine_t) < 1.0)) return false;
  const double cosine_t = std::sqrt((1.0 - sine_t) * (1.0 + sine_t));
  // f is (nearly) upright, or the roll so great that every yaw gives the same: no heading.
  if (!(std::hypot(f.x(), f.y()) > 1e-6)) return false;
  const double yaw = std::atan2(f.y(), f.x()) - std::atan2(sine * sine_t, cosine_t);
  const Vector3d y(-std::sin(yaw) * cosine, std::cos(yaw) * cosine, sine);  // the leg's pitch axis
  const double ankle_roll = std::atan2(-y.dot(wanted.col(2)), y.dot(wanted.col(1)));
  const double pitch = std::atan2(sine_t, cosine_t) - sign(2) * joints[joint(swing, 2)] - sign(3) * joints[joint(swing, 3)];
  constexpr double kTurn = 6.283185307179586476925286766559;
  joints[joint(swing, 0)] = sign(0) * std::remainder(yaw, kTurn);
  joints[joint(swing, 4)] = sign(4) * std::remainder(pitch, kTurn);
  joints[joint(swing, 5)] = sign(5) * ankle_roll;
  return true;
}

double heading_of(const Model& model, Side support, const Joints& joints) {
  const Matrix3d turn = sole_turn(model, support, joints).transpose() * sole_turn(model, other(support), joints);
  return std::atan2(turn(1, 0), turn(0, 0));
}

}  // namespace foothold::bioloid
