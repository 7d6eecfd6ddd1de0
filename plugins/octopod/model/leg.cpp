// A leg's joints in closed form: its plane by the foot's bearing, then two links in the plane.
//
// In the plane the foot lies at (x, z) seen from the femur's joint, d = |(x, z)|:
//   tan^2(q3 / 2) = ((f + t)^2 - d^2) / (d^2 - (f - t)^2),  q2 = atan2(z, x) - atan2(t sin q3, f + t cos q3).
// The half angle keeps its digits at a stretched and at a folded leg, where the cosine law loses half of them.
#include <cmath>
#include <numbers>

#include "octopod/model/body.hpp"

namespace foothold::octopod {
namespace {

constexpr double kRounding = 1e-12;  // m, by which a point may lie beyond the stretched leg and still count as reached

struct Planar {
  double q2 = 0.0, q3 = 0.0;
};

double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

// |q3| of the two links whose ends are d apart; empty if they cannot be.
std::optional<double> knee(const Model& model, double d) {
  const double stretched = model.femur + model.tibia, folded = std::abs(model.femur - model.tibia);
  if (d > stretched + kRounding || d < folded - kRounding) return std::nullopt;
  const double to_stretched = std::max(0.0, (stretched - d) * (stretched + d));
  const double to_folded = std::max(0.0, (d - folded) * (d + folded));
  return 2 * std::atan2(std::sqrt(to_stretched), std::sqrt(to_folded));
}

Planar planar(const Model& model, double x, double z, double q3) {
  const double across = model.tibia * std::sin(q3), along = model.femur + model.tibia * std::cos(q3);
  return {wrapped(std::atan2(z, x) - std::atan2(across, along)), q3};
}

// Where the foot is seen from the shoulder: bearing from the leg's side, level distance, height.
struct Bearing {
  double yaw, level, up;
};
Bearing bearing(const Model& model, int which, const Vector3d& foot) {
  const Vector3d from = foot - model.shoulders[static_cast<std::size_t>(which % 4)];
  return {std::atan2(from.x(), side(which) * from.y()), std::hypot(from.x(), from.y()), from.z()};
}

}  // namespace

LegSolutions inverse_leg(const Model& model, int which, const Vector3d& foot) {
  const Bearing at = bearing(model, which, foot);
  LegSolutions out;
  for (const bool away : {false, true}) {
    const double x = (away ? -at.level : at.level) - model.coxa;
    const std::optional<double> bend = knee(model, std::hypot(x, at.up));
    if (!bend) continue;
    const double yaw = away ? wrapped(at.yaw + std::numbers::pi) : at.yaw;
    for (const double sign : {-1.0, 1.0}) {
      const Planar joints = planar(model, x, at.up, sign * *bend);
      out.joints[static_cast<std::size_t>(out.count++)] = {yaw, joints.q2, joints.q3};
      if (*bend == 0.0) break;
    }
  }
  return out;
}

std::optional<Vector3d> natural_leg(const Model& model, int which, const Vector3d& foot) {
  const Bearing at = bearing(model, which, foot);
  const bool away = std::abs(at.yaw) > std::numbers::pi / 2;
  const double x = (away ? -at.level : at.level) - model.coxa;
  const std::optional<double> bend = knee(model, std::hypot(x, at.up));
  if (!bend) return std::nullopt;
  const Planar joints = planar(model, x, at.up, -*bend);
  return Vector3d(away ? wrapped(at.yaw + std::numbers::pi) : at.yaw, joints.q2, joints.q3);
}

}  // namespace foothold::octopod
