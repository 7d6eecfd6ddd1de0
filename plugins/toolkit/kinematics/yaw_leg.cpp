// Closed forms of the leg with a yaw and two parallel pitches.
#include "kinematics/yaw_leg.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foothold::kinematics {

namespace {

double wrapped(double angle) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double rest = std::remainder(angle, kTurn);
  return rest <= -std::numbers::pi ? rest + kTurn : rest;
}

}  // namespace

YawLeg::Points YawLeg::forward(const Eigen::Vector3d& joints) const {
  const Eigen::Vector3d out(std::cos(joints[0]), std::sin(joints[0]), 0.0);
  const double lower = joints[1] + joints[2];
  Points points;
  points.hip = coxa * out - drop * Eigen::Vector3d::UnitZ();
  points.knee = points.hip + femur * (std::cos(joints[1]) * out + std::sin(joints[1]) * Eigen::Vector3d::UnitZ());
  points.foot = points.knee + tibia * (std::cos(lower) * out + std::sin(lower) * Eigen::Vector3d::UnitZ());
  return points;
}

// The knee's angle, 0 stretched, where femur's axis and foot are so far apart. From its half: the cosine law would lose half of the
// digits at the stretched and at the folded leg.
std::optional<double> YawLeg::bend(double distance, double slack) const {
  const double stretched = femur + tibia, folded = std::abs(femur - tibia);
  if (distance > stretched + slack || distance < folded - slack) return std::nullopt;
  const double to_stretched = std::max(0.0, (stretched - distance) * (stretched + distance));
  const double to_folded = std::max(0.0, (distance - folded) * (distance + folded));
  return 2.0 * std::atan2(std::sqrt(to_stretched), std::sqrt(to_folded));
}

Eigen::Vector3d YawLeg::joints(double yaw, double out, double down, double tibia_angle) const {
  const double femur_angle =
      std::atan2(down, out) - std::atan2(tibia * std::sin(tibia_angle), femur + tibia * std::cos(tibia_angle));
  return {yaw, wrapped(femur_angle), tibia_angle};
}

YawLeg::Solutions YawLeg::inverse(const Eigen::Vector3d& foot, double yaw_on_axis, double slack) const {
  Solutions solutions;
  const double radius = std::hypot(foot.x(), foot.y());
  const double facing = radius > 0.0 ? std::atan2(foot.y(), foot.x()) : yaw_on_axis;
  const double down = foot.z() + drop;
  for (const bool behind : {false, true}) {
    const double out = (behind ? -radius : radius) - coxa;
    const auto knee = bend(std::hypot(out, down), slack);
    if (!knee) continue;
    const double yaw = wrapped(behind ? facing + std::numbers::pi : facing);
    for (const double side : {-1.0, 1.0}) {
      if (side > 0.0 && *knee == 0.0) continue;  // the stretched leg has one solution, not two
      solutions.joints[static_cast<std::size_t>(solutions.count++)] = joints(yaw, out, down, side * *knee);
    }
  }
  return solutions;
}

std::optional<Eigen::Vector3d> YawLeg::standing(const Eigen::Vector3d& foot, double slack) const {
  const bool behind = foot.x() < 0.0;
  const double radius = std::hypot(foot.x(), foot.y()), down = foot.z() + drop;
  const double out = (behind ? -radius : radius) - coxa;
  const auto knee = bend(std::hypot(out, down), slack);
  if (!knee) return std::nullopt;
  const double yaw = behind ? std::atan2(-foot.y(), -foot.x()) : std::atan2(foot.y(), foot.x());
  return joints(yaw, out, down, -*knee);
}

}  // namespace foothold::kinematics
