// A transition seen by an eye that looks many times: contacts, equilibrium by another method, bodies by points.
#pragma once

#include "contact/projection.hpp"
#include "crossing.hpp"
#include "octopod/transition/transition.hpp"

namespace foothold::octopod {

inline Coordinates mixed(const MotionPoint& a, const MotionPoint& b, double part) {
  Posture out;
  const Eigen::Quaterniond from(a.base.linear()), to(b.base.linear());
  out.base.linear() = from.slerp(part, to).toRotationMatrix();
  out.base.translation() = (1 - part) * a.base.translation() + part * b.base.translation();
  for (std::size_t k = 0; k < a.joints.size(); ++k) out.joints.push_back((1 - part) * a.joints[k] + part * b.joints[k]);
  return from_posture(out);
}

struct Seen {
  double slip = 0.0;       // m, of feet that stand
  double depth = -1.0;     // m, of bodies and legs in the ground
  double foot_depth = -1;  // m, of feet in the air
  double apart = 1.0;      // m, between legs, and legs and bodies
  int unstable = 0, instants = 0, fewest_feet = kLegs;
  std::array<int, kLegs> swings{};
};

// `from` and `to`: where feet may stand. Feet that are nearer than 0.3 mm to such a place stand.
inline Seen see(const Model& model, const terrain::Terrain& ground, const Standing& from, const Standing& to,
                const std::vector<MotionPoint>& motion, double friction, int between_points, bool look_at_bodies) {
  Seen out;
  std::array<bool, kLegs> stood;
  stood.fill(true);
  for (std::size_t i = 0; i + 1 < motion.size(); ++i)
    for (int k = 0; k < between_points; ++k) {
      const Coordinates at = mixed(motion[i], motion[i + 1], static_cast<double>(k) / between_points);
      std::vector<contact::Contact> standing;
      for (int which = 0; which < kLegs; ++which) {
        const auto leg_at = static_cast<std::size_t>(which);
        const Vector3d foot = leg(model, at, which).foot;
        const double old = (foot - from.feet[leg_at].point).norm(), fresh = (foot - to.feet[leg_at].point).norm();
        const bool stands = std::min(old, fresh) < 3e-4;
        if (stands) {
          const Footing& footing = old < fresh ? from.feet[leg_at] : to.feet[leg_at];
          standing.push_back({footing.point, footing.normal});
          out.slip = std::max(out.slip, std::min(old, fresh));
        } else {
          out.foot_depth = std::max(out.foot_depth, height_at(ground, foot) - foot.z());
          if (stood[leg_at]) ++out.swings[leg_at];
        }
        stood[leg_at] = stands;
      }
      if (out.instants % 5 == 0) out.apart = std::min(out.apart, nearest_parts(modules(model, at), legs_of(at)).distance);
      ++out.instants;
      out.fewest_feet = std::min(out.fewest_feet, static_cast<int>(standing.size()));
      out.unstable +=
          !contact::judge_by_projection(standing, centre_of_mass(model, at), friction, contact::FrictionCone::pyramid(10)).stable;
      if (look_at_bodies) out.depth = std::max(out.depth, depth(model, ground, at, 0.3, 3));
    }
  return out;
}

}  // namespace foothold::octopod
