// The postures between poses by hand, and a walk of them.
#include "hand_made.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::bioloid::testing {

physics::JointPath motion_through(const Model& model, const std::vector<Pose>& poses) {
  physics::JointPath out{joints_of(model, poses.front())};
  for (std::size_t k = 1; k < poses.size(); ++k) {
    const Pose &a = poses[k - 1], &b = poses[k];
    const double way = std::max({(b.torso - a.torso).norm(), (b.soles[0] - a.soles[0]).norm(), (b.soles[1] - a.soles[1]).norm()});
    const int parts = std::max(1, static_cast<int>(std::ceil(way / 0.002)));
    for (int part = 1; part <= parts; ++part) {
      const double t = static_cast<double>(part) / parts;
      Pose between;
      between.torso = a.torso + t * (b.torso - a.torso);
      for (const std::size_t side : {0u, 1u}) between.soles[side] = a.soles[side] + t * (b.soles[side] - a.soles[side]);
      out.push_back(joints_of(model, between));
    }
  }
  return out;
}

std::vector<Pose> walk_by_hand(const Model& model, int steps, double length, double height) {
  std::vector<Pose> out{standing(model, 0.120)};
  const auto centre = [&] { return Vector3d(0.5 * (out.back().soles[0] + out.back().soles[1])); };
  for (int k = 0; k < steps; ++k) {
    const std::size_t support = k % 2 == 0 ? 0 : 1, swing = 1 - support;
    out.push_back(shifted(model, out.back(), out.back().soles[support]));
    const double ahead = k + 1 < steps ? length : 0.0;
    const double to = out.back().soles[support].x() + ahead;
    for (const auto& [x, z] : {std::pair{out.back().soles[swing].x(), height}, {to, height}, {to, 0.0}}) {
      Pose next = out.back();
      next.soles[swing].x() = x;
      next.soles[swing].z() = z;
      out.push_back(shifted(model, next, next.soles[support]));
    }
    out.push_back(shifted(model, out.back(), centre()));
  }
  return out;
}

}  // namespace foothold::bioloid::testing
