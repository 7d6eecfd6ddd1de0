// An octopod's leg is the toolkit's leg in the frame of its shoulder: X' = +-Y outwards, Z' = Z, so a yaw turns forwards on the
// right and backwards on the left.
#include <cmath>

#include "octopod/model/body.hpp"

namespace foothold::octopod {
namespace {

// The module's frame to the shoulder's axes, and back; `left` is side().
Vector3d to_shoulder(double left, const Vector3d& v) { return {left * v.y(), -left * v.x(), v.z()}; }
Vector3d to_module(double left, const Vector3d& v) { return {-left * v.y(), left * v.x(), v.z()}; }
Vector3d mirrored(double left, const Vector3d& joints) { return {-left * joints[0], joints[1], joints[2]}; }

const Vector3d& shoulder_of(const Model& model, int which) { return model.shoulders[static_cast<std::size_t>(which % 4)]; }

}  // namespace

LegPoints leg_in_module(const Model& model, int which, const Vector3d& joints) {
  const double left = side(which);
  const Vector3d& shoulder = shoulder_of(model, which);
  const auto points = model.leg().forward(mirrored(left, joints));
  return {shoulder, shoulder + to_module(left, points.knee), shoulder + to_module(left, points.foot)};
}

LegPoints leg(const Model& model, const Coordinates& at, int which) {
  const Isometry3d module = module_of(which) == 0 ? at.front : rear(model, at);
  const LegPoints own = leg_in_module(model, which, at.legs[static_cast<std::size_t>(which)]);
  return {module * own.shoulder, module * own.knee, module * own.foot};
}

Eigen::Matrix3d leg_jacobian(const Model& model, int which, const Vector3d& joints) {
  const double s1 = std::sin(joints[0]), c1 = std::cos(joints[0]), left = side(which);
  const double s2 = std::sin(joints[1]), c2 = std::cos(joints[1]);
  const double s23 = std::sin(joints[1] + joints[2]), c23 = std::cos(joints[1] + joints[2]);
  const double out = model.coxa + model.femur * c2 + model.tibia * c23;
  const double lower_out = -model.tibia * s23, lower_up = model.tibia * c23;
  const double whole_out = lower_out - model.femur * s2, whole_up = lower_up + model.femur * c2;
  Eigen::Matrix3d jacobian;
  jacobian.col(0) << out * c1, -left * out * s1, 0;
  jacobian.col(1) << whole_out * s1, left * whole_out * c1, whole_up;
  jacobian.col(2) << lower_out * s1, left * lower_out * c1, lower_up;
  return jacobian;
}

LegSolutions inverse_leg(const Model& model, int which, const Vector3d& foot) {
  const double left = side(which);
  LegSolutions out = model.leg().inverse(to_shoulder(left, foot - shoulder_of(model, which)));
  for (Vector3d& joints : out.joints) joints = mirrored(left, joints);
  return out;
}

std::optional<Vector3d> natural_leg(const Model& model, int which, const Vector3d& foot) {
  const double left = side(which);
  const auto joints = model.leg().standing(to_shoulder(left, foot - shoulder_of(model, which)));
  if (!joints) return std::nullopt;
  return mirrored(left, *joints);
}

}  // namespace foothold::octopod
