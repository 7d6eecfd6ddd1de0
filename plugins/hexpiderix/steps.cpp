#include "hexpiderix/steps.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::hexpiderix {
namespace {

constexpr int kPoints = 32;      // of the thorax' way
constexpr int kPointsDown = 16;  // of a foot that comes down

double slowest(const Joints& a, const Joints& b) {
  double most = 0.0;
  for (std::size_t leg = 0; leg < kLegs; ++leg) most = std::max(most, (a[leg] - b[leg]).cwiseAbs().maxCoeff());
  return most;
}

void add(const Model& model, const Coordinates& at, const Coordinates& before, std::vector<MotionPoint>& out) {
  const double time = out.empty() ? 0.0 : out.back().time + slowest(at.legs, before.legs) / model.joint_speed;
  out.push_back({time, at.thorax, to_posture(at).joints});
}

// Joints of a swinging leg part of the way between two postures.
Vector3d between(const Vector3d& a, const Vector3d& b, double part) { return a + part * (b - a); }

}  // namespace

Posture standing_posture(const Coordinates& at, const Footholds& footholds) {
  Posture out = to_posture(at);
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    if (!footholds.supports[leg]) continue;
    const Vector3d up = footholds.normals[leg], ahead = at.thorax.linear().col(0);
    Contact contact{"L" + std::to_string(leg + 1), Isometry3d::Identity(), ""};
    contact.frame.linear() = axes_along(up, ahead);
    contact.frame.translation() = footholds.points[leg];
    out.stance.push_back(contact);
  }
  return out;
}

std::vector<MotionPoint> adapting_motion(const Model& model, const Start& from, const Adaption& to) {
  std::vector<MotionPoint> out;
  Coordinates at = from.at;
  add(model, at, at, out);
  const Legs joining = to.footholds.supports & ~from.situation.footholds.supports;
  if (joining.any()) {
    const Isometry3d to_thorax = at.thorax.inverse();
    std::array<Vector3d, kLegs> above{};
    for (std::size_t leg = 0; leg < kLegs; ++leg) above[leg] = leg_points(model, leg, at.legs[leg]).foot;
    for (int k = 1; k <= kPointsDown; ++k) {
      const double part = static_cast<double>(k) / kPointsDown;
      Coordinates next = at;
      for (std::size_t leg = 0; leg < kLegs; ++leg) {
        if (!joining[leg]) continue;
        const auto joints = reach(model, leg, above[leg] + part * (to_thorax * to.footholds.points[leg] - above[leg]));
        if (!joints) return {};
        next.legs[leg] = *joints;
      }
      add(model, next, at, out);
      at = next;
    }
  }
  const Isometry3d begin = at.thorax, end = to.evaluation.at.thorax;
  const Eigen::Quaterniond q0(begin.linear()), q1(end.linear());
  const Joints swinging = at.legs;
  for (int k = 1; k <= kPoints; ++k) {
    const double part = static_cast<double>(k) / kPoints;
    Coordinates next = at;
    if (k == kPoints) {
      next = to.evaluation.at;
    } else {
      next.thorax.translation() = begin.translation() + part * (end.translation() - begin.translation());
      next.thorax.linear() = q0.slerp(part, q1).toRotationMatrix();
      for (std::size_t leg = 0; leg < kLegs; ++leg) {
        if (!to.footholds.supports[leg]) {
          next.legs[leg] = between(swinging[leg], to.evaluation.at.legs[leg], part);
          continue;
        }
        const auto joints = reach(model, leg, next.thorax.inverse() * to.footholds.points[leg]);
        if (!joints) return {};
        next.legs[leg] = *joints;
      }
    }
    add(model, next, at, out);
    at = next;
  }
  return out;
}

Step to_step(const Model& model, const Start& from, const Adaption& to) {
  Step step;
  step.label = to.about;
  step.after = standing_posture(to.evaluation.at, to.footholds);
  step.placed = step.after.stance;
  step.motion = adapting_motion(model, from, to);
  step.attributes.push_back({"strategy", to.about});
  step.cost = -to.evaluation.nesm;
  return step;
}

Step to_step(const Model& model, const Stand& from, const HalfCycle& half_cycle, int number, double cost) {
  Step step;
  step.after = standing_posture(half_cycle.to.at, half_cycle.to.feet);
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    if (half_cycle.swinging[leg]) step.placed.push_back(step.after.stance[leg]);
  if (step.placed.empty()) step.placed = step.after.stance;
  const char* what = half_cycle.swinging.none() ? "the thorax shifts on six feet"
                     : half_cycle.swinging[0]   ? "triad 1 steps"
                                                : "triad 2 steps";
  step.label = "half cycle " + std::to_string(number) + ": " + what;
  add(model, from.at, from.at, step.motion);
  for (std::size_t k = 1; k < half_cycle.way.size(); ++k) add(model, half_cycle.way[k], half_cycle.way[k - 1], step.motion);
  step.cost = cost;
  return step;
}

}  // namespace foothold::hexpiderix
