// A transition as points in time.
#include <algorithm>

#include "octopod/transition/transition.hpp"

namespace foothold::octopod {
namespace {

constexpr double kShortest = 1e-3;  // s, between two points

double time_between(const Model& model, const Posture& a, const Posture& b, const Coordinates& from, const Coordinates& to,
                    int leg) {
  double time = kShortest;
  for (std::size_t k = 0; k < a.joints.size(); ++k) time = std::max(time, std::abs(b.joints[k] - a.joints[k]) / model.joint_speed);
  time = std::max(time, (b.base.translation() - a.base.translation()).norm() / model.foot_speed);
  time = std::max(time, (rear(model, to).translation() - rear(model, from).translation()).norm() / model.foot_speed);
  if (leg >= 0)
    time = std::max(time, (octopod::leg(model, to, leg).foot - octopod::leg(model, from, leg).foot).norm() / model.foot_speed);
  return time;
}

}  // namespace

std::vector<MotionPoint> to_motion(const Model& model, const Transition& transition) {
  std::vector<MotionPoint> out;
  Posture last;
  const Coordinates* before = nullptr;
  for (const Phase& phase : transition.phases)
    for (const Coordinates& at : phase.way) {
      // A phase begins where the one before ended.
      if (before != nullptr && &at == &phase.way.front()) continue;
      Posture posture = to_posture(at);
      const double time = before == nullptr ? 0.0 : out.back().time + time_between(model, last, posture, *before, at, phase.leg);
      out.push_back({time, posture.base, posture.joints});
      last = std::move(posture);
      before = &at;
    }
  return out;
}

}  // namespace foothold::octopod
