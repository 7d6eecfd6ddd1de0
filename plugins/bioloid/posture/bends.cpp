// Rates of links and the bounds that follow.
#include "bioloid/posture/bends.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::bioloid {

Rates::Rates(const Legs& legs, const Joints& a, const Joints& b) {
  const Joints d = b - a;
  std::array<Lanes, kLegJoints> w;
  for (std::size_t k = 0; k < kLegJoints; ++k) {
    std::memcpy(&w[k], d.data() + leg_joint(Side::kRight, k), sizeof(Lanes));
    w[k] *= legs.signs[k];
  }
  yaw = w[0];
  roll = magnitude(w[1]);
  pitch = {w[2], w[2] + w[3], w[2] + w[3] + w[4]};
  ankle = magnitude(w[5]);
  arms = std::max(std::abs(d[0]) + std::abs(d[2]) + std::abs(d[4]), std::abs(d[1]) + std::abs(d[3]) + std::abs(d[5]));
}

Weights::Weights(const Model& model, Side support) {
  const double whole = model.mass();
  const Vector3d &upper = model.leg().thigh, &lower = model.leg().shin;
  const auto body = [&](Side side, std::size_t k) -> const Body& { return model.bodies[leg_joint(side, k) + 1]; };
  const auto own = [&](Side side, std::size_t k) -> Vector3d { return body(side, k).mass * body(side, k).centre_of_mass; };
  double beyond = whole - body(support, 5).mass - body(support, 4).mass - body(support, 3).mass;
  ankle = own(support, 4).norm() / whole;
  shin = (own(support, 3) - (beyond + body(support, 3).mass) * lower).norm() / whole;
  beyond -= body(support, 2).mass;
  thigh = (own(support, 2) - (beyond + body(support, 2).mass) * upper).norm() / whole;
  hip = own(support, 1).norm() / whole;
  bracket = own(support, 0).norm() / whole;
  const Side swing = other(support);
  double leg = 0.0;
  for (std::size_t k = 0; k < kLegJoints; ++k) leg += body(swing, k).mass;
  double torso_mass = 0.0;
  for (std::size_t b = 0; b <= 6; ++b) torso_mass += model.bodies[b].mass;
  torso = (leg * (model.hip(swing) - model.hip(support)) - torso_mass * model.hip(support)) / whole;
  const double below_ankle = body(swing, 4).mass + body(swing, 5).mass;
  swing_bracket = own(swing, 0).norm() / whole;
  swing_hip = own(swing, 1).norm() / whole;
  swing_thigh = (own(swing, 2) + (below_ankle + body(swing, 3).mass) * upper).norm() / whole;
  swing_shin = (own(swing, 3) + below_ankle * lower).norm() / whole;
  swing_ankle = own(swing, 4).norm() / whole;
  swing_foot = own(swing, 5).norm() / whole;
}

std::array<Lanes, kLinks> bends_from_torso(const Legs& legs, const Rates& rates, Lanes across) {
  // Of the turns, only those count whose outermost axis moves points along the direction: yaw and roll wholly, pitch by `across`.
  const Lanes base = magnitude(rates.yaw) + rates.roll;
  std::array<Lanes, 3> pitch, q;
  for (std::size_t k = 0; k < 3; ++k) {
    pitch[k] = magnitude(rates.pitch[k]);
    q[k] = base * (base + 2.0 * pitch[k]) + across * pitch[k] * pitch[k];
  }
  const Lanes a = rates.ankle, foot = base * (base + 2.0 * (pitch[2] + a)) + across * pitch[2] * (pitch[2] + 2.0 * a) + a * a;
  const Lanes knee = legs.thigh_length * q[0], ankle = knee + legs.shin_length * q[1];
  const auto& box = legs.boxes;
  return {box[0].reach * base * base, box[1].reach * q[0], knee + box[2].reach * q[1], ankle + box[3].reach * q[2],
          ankle + box[4].reach * foot};
}

}  // namespace foothold::bioloid
