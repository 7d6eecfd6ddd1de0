// The three coupled joints in closed form: the swing foot's heading and level fix its x axis f in the torso's frame, and
// f = Rz(yaw) (cos t, sin roll sin t, -cos roll sin t) with t the foot's whole pitch.
#include "bioloid/posture/nine.hpp"

#include <cmath>
#include <numbers>

#include "bioloid/posture/lanes.hpp"

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

  // The supporting sole's axes in the torso's frame: Rz(yaw) Rx(roll) Ry(pitch) Rx(ankle).
  const auto angle = [&](Side side, std::size_t k) { return model.sign(side, k) * joints[joint(side, k)]; };
  Lanes sines, cosines;
  sine_and_cosine(Lanes{angle(support, 0), angle(support, 1)}, sines, cosines);
  const double sy = sines[0], cy = cosines[0], sr = sines[1], cr = cosines[1];
  sine_and_cosine(Lanes{angle(support, 2) + angle(support, 3) + angle(support, 4), angle(support, 5)}, sines, cosines);
  const double sp = sines[0], cp = cosines[0], sa = sines[1], ca = cosines[1];
  sine_and_cosine(Lanes{angle(swing, 1), heading}, sines, cosines);
  const double sine = sines[0], cosine = cosines[0], sh = sines[1], ch = cosines[1];
  const Vector3d x(cy * cp - sy * sr * sp, sy * cp + cy * sr * sp, -cr * sp), across(-sy * cr, cy * cr, sr);
  const Vector3d upright(cy * sp + sy * sr * cp, sy * sp - cy * sr * cp, cr * cp);
  const Vector3d y = ca * across + sa * upright, z = ca * upright - sa * across;
  const Vector3d f = ch * x + sh * y, left = ch * y - sh * x;  // the swing sole's, as wanted

  const double sine_t = -f.z() / cosine;
  if (!(std::abs(sine_t) < 1.0)) return false;
  const double cosine_t = std::sqrt((1.0 - sine_t) * (1.0 + sine_t));
  // f is (nearly) upright: no heading.
  const double flat = f.x() * f.x() + f.y() * f.y();
  if (!(flat > 1e-12)) return false;
  // The yaw turns (cos t, sin roll sin t) to (f.x, f.y), which is as long.
  const double along = cosine_t * f.x() + sine * sine_t * f.y(), turned = cosine_t * f.y() - sine * sine_t * f.x();
  const Vector3d pitch_axis(-turned / flat * cosine, along / flat * cosine, sine);
  double pitch = std::asin(sine_t) - angle(swing, 2) - angle(swing, 3);
  if (std::abs(pitch) > std::numbers::pi) pitch = std::remainder(pitch, 2.0 * std::numbers::pi);
  joints[joint(swing, 0)] = model.sign(swing, 0) * std::atan2(turned, along);
  joints[joint(swing, 4)] = model.sign(swing, 4) * pitch;
  joints[joint(swing, 5)] = model.sign(swing, 5) * std::atan2(-pitch_axis.dot(z), pitch_axis.dot(left));
  return true;
}

double heading_of(const Model& model, Side support, const Joints& joints) {
  const Matrix3d turn = sole_turn(model, support, joints).transpose() * sole_turn(model, other(support), joints);
  return std::atan2(turn(1, 0), turn(0, 0));
}

}  // namespace foothold::bioloid
