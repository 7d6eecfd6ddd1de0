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

YawLeg::Solutions YawLeg::inverse(const Eigen::Vector3d& foot, double yaw_on_axis, double slack) const {
  Solutions solutions;
  const double radius = std::hypot(foot.x(), foot.y());
  const double facing = radius > 0.0 ? std::atan2(foot.y(), foot.x()) : yaw_on_axis;
  const double down = foot.z() + drop;
  for (const bool behind : {false, true}) {
    const double out = (behind ? -radius : radius) - coxa;
    const double distance = std::hypot(out, down);
    if (distance > femur + tibia + slack || distance < std::abs(femur - tibia) - slack) continue;
    const double cosine = (distance * distance - femur * femur - tibia * tibia) / (2.0 * femur * tibia);
    const double bend = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double yaw = wrapped(behind ? facing + std::numbers::pi : facing);
    for (const double side : {-1.0, 1.0}) {
      if (side > 0.0 && bend == 0.0) continue;  // the stretched leg has one solution, not two
      const double tibia_angle = side * bend;
      const double femur_angle =
          std::atan2(down, out) - std::atan2(tibia * std::sin(tibia_angle), femur + tibia * std::cos(tibia_angle));
      solutions.joints[static_cast<std::size_t>(solutions.count++)] = {yaw, wrapped(femur_angle), tibia_angle};
    }
  }
  return solutions;
}

}  // namespace foothold::kinematics
