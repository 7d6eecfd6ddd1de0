#include "hyrecro/motion/actuators.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foothold::hyrecro {

Actuators to_actuators(const Model& model, const Coordinates& c) {
  Actuators out;
  for (int j = 0; j < 2; ++j) {
    const Leg& leg = c.leg[static_cast<std::size_t>(j)];
    const auto ankle = model.mechanism.lengths({leg.phi1, leg.y1}), upper = model.mechanism.lengths({leg.phi2, leg.y2});
    out.segment<4>(4 * j) << ankle.left, ankle.right, upper.left, upper.right;
  }
  out.tail<2>() << c.hip[0], c.hip[1];
  return out;
}

Coordinates from_actuators(const Model& model, const Actuators& q) {
  Coordinates out;
  for (int j = 0; j < 2; ++j) {
    const auto ankle = model.mechanism.forward({q[4 * j], q[4 * j + 1]}),
               upper = model.mechanism.forward({q[4 * j + 2], q[4 * j + 3]});
    out.leg[static_cast<std::size_t>(j)] = {ankle.phi, ankle.y, upper.phi, upper.y};
  }
  out.hip = {q[8], q[9]};
  return out;
}

double duration(const Model& model, const Actuators& a, const Actuators& b) {
  const Actuators way = (b - a).cwiseAbs();
  return std::max(way.head<8>().maxCoeff() / model.actuator_speed, way.tail<2>().maxCoeff() / model.hip_speed);
}

Actuators with_nearest_turns(const Actuators& from, const Actuators& to) {
  Actuators out = to;
  for (int i = 8; i < 10; ++i) out[i] = from[i] + std::remainder(to[i] - from[i], 2.0 * std::numbers::pi);
  return out;
}

}  // namespace foothold::hyrecro
