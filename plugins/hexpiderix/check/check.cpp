#include "hexpiderix/check/check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hexpiderix/check/clear.hpp"
#include "hexpiderix/check/margins.hpp"
#include "judge/refusal.hpp"

namespace foothold::hexpiderix {
namespace {

using judge::refuse;

constexpr double kSlip = 1e-3;  // m, that a supporting foot may stray between two points of a motion, where joints move evenly
constexpr int kBetween = 4;     // looks between two points of a motion

// The surface's nearest triangle within `most` of a point, by looking at every one that could be.
const Vector3d* normal_at(const terrain::Surface& surface, const Vector3d& point, const Vector3d& wanted, double most) {
  const terrain::Terrain& terrain = surface.terrain();
  const collision::Bounds look{(point.array() - 2 * most).matrix(), (point.array() + 2 * most).matrix()};
  const Vector3d* best = nullptr;
  for (const int t : surface.touching(look)) {
    if (!terrain.ground[static_cast<std::size_t>(t)]) continue;
    if ((terrain::nearest_on_triangle(point, terrain.corner(t, 0), terrain.corner(t, 1), terrain.corner(t, 2)) - point).norm() >
        most)
      continue;
    const Vector3d& normal = terrain.normals[static_cast<std::size_t>(t)];
    if (best == nullptr || (normal - wanted).norm() < (*best - wanted).norm()) best = &normal;
  }
  return best;
}

struct Stance {
  Legs legs;
  std::array<Vector3d, kLegs> points{};
  std::vector<Support> supports;  // leg by leg
};

Stance judge_stance(const terrain::Surface& surface, const Posture& posture, const char* which) {
  Stance out;
  std::array<Support, kLegs> by_leg{};
  for (const Contact& contact : posture.stance) {
    std::size_t leg = 0;
    while (leg < kLegs && contact.limb != "L" + std::to_string(leg + 1)) ++leg;
    if (leg == kLegs) refuse(which, ": '", contact.limb, "' is no leg");
    if (out.legs[leg]) refuse(which, ": ", contact.limb, " stands twice");
    out.legs[leg] = true;
    out.points[leg] = contact.frame.translation();
    const Vector3d up = contact.frame.linear().col(2);
    const Vector3d* normal = normal_at(surface, out.points[leg], up, judge::kPoseTolerance);
    if (normal == nullptr)
      refuse(which, ": foot ", contact.limb, " is ", surface.nearest(out.points[leg]).distance, " m off the ground");
    if ((*normal - up).norm() > judge::kPoseTolerance)
      refuse(which, ": the contact of ", contact.limb, " is not along the ground's normal");
    by_leg[leg] = {out.points[leg], *normal};
  }
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    if (out.legs[leg]) out.supports.push_back(by_leg[leg]);
  if (out.legs.count() < 3) refuse(which, ": only ", out.legs.count(), " feet stand");
  return out;
}

void judge_joints(const Model& model, std::span<const double> joints, const char* which) {
  if (joints.size() != 3 * kLegs) refuse(which, " gives ", joints.size(), " joints, not ", 3 * kLegs);
  for (std::size_t k = 0; k < joints.size(); ++k)
    if (!model.limits[k % 3].holds(joints[k], judge::kSame))
      refuse(which, ": L", k / 3 + 1, ".q", k % 3 + 1, " is ", joints[k], " rad, outside ", model.limits[k % 3].low, " to ",
             model.limits[k % 3].high);
}

// How far the farthest supporting foot is from its place by the legs' kinematics.
double strayed(const Skeleton& at, const Stance& stance, Legs legs) {
  double most = 0.0;
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    if (legs[leg]) most = std::max(most, (at.limbs[leg].foot - stance.points[leg]).norm());
  return most;
}

struct Course {
  double slip = 0.0, least_tipping = std::numeric_limits<double>::infinity();
};

// The feet that stand in both postures, at the same places.
Stance held_between(const Stance& from, const Stance& to) {
  Stance out;
  for (std::size_t leg = 0, k = 0; leg < kLegs; ++leg) {
    if (!from.legs[leg]) continue;
    const Support& support = from.supports[k++];
    if (!to.legs[leg] || (to.points[leg] - from.points[leg]).norm() > judge::kSame) continue;
    out.legs[leg] = true;
    out.points[leg] = from.points[leg];
    out.supports.push_back(support);
  }
  if (out.legs.count() < 3) refuse("only ", out.legs.count(), " feet hold while the others move");
  return out;
}

// `held`: the feet that hold all along.
Course judge_motion(const Model& model, const terrain::Surface& surface, const Step& step, const Posture& before,
                    const Stance& held, const CheckOptions& options) {
  const MotionPoint &first = step.motion.front(), &last = step.motion.back();
  const auto off = [](const MotionPoint& point, const Posture& posture) {
    double most = judge::error_between(point.base, posture.base);
    for (std::size_t k = 0; k < posture.joints.size(); ++k) most = std::max(most, std::abs(point.joints[k] - posture.joints[k]));
    return most;
  };
  for (const MotionPoint& point : step.motion) judge_joints(model, point.joints, "a point of the motion");
  if (off(first, before) > judge::kPoseTolerance) refuse("the motion does not begin at the posture before");
  if (off(last, step.after) > judge::kPoseTolerance) refuse("the motion does not end at the posture after");
  Course out;
  const auto holds = [&](const Posture& end) {
    return balanced(held.supports, skeleton(model, end.base, end.joints).centre_of_mass, options.friction);
  };
  const bool both_balanced = holds(before) && holds(step.after);  // a robot that begins out of balance may come into it
  for (std::size_t k = 1; k < step.motion.size(); ++k) {
    const MotionPoint &a = step.motion[k - 1], &b = step.motion[k];
    double fastest = 0.0;
    for (std::size_t j = 0; j < a.joints.size(); ++j) fastest = std::max(fastest, std::abs(b.joints[j] - a.joints[j]));
    if (fastest > model.joint_speed * (b.time - a.time) + judge::kPoseTolerance)
      refuse("the motion turns a joint by ", fastest, " rad in ", b.time - a.time, " s");
    for (int look = k == 1 ? 0 : 1; look <= kBetween; ++look) {
      const double part = static_cast<double>(look) / kBetween;
      Isometry3d base = Isometry3d::Identity();
      base.translation() = a.base.translation() + part * (b.base.translation() - a.base.translation());
      base.linear() = Eigen::Quaterniond(a.base.linear()).slerp(part, Eigen::Quaterniond(b.base.linear())).toRotationMatrix();
      std::vector<double> joints(a.joints);
      for (std::size_t j = 0; j < joints.size(); ++j) joints[j] += part * (b.joints[j] - a.joints[j]);
      const Skeleton at = skeleton(model, base, joints);
      const double stray = strayed(at, held, held.legs);
      out.slip = std::max(out.slip, stray);
      if (stray > (look % kBetween == 0 ? judge::kPoseTolerance : kSlip))
        refuse("a supporting foot strays by ", stray, " m on the way");
      judge_clear(model, surface, base, at, held.legs, options.clearance, "on the way");
      if (look == kBetween && !balanced(held.supports, at.centre_of_mass, options.friction) && both_balanced)
        refuse("the feet that hold are not in equilibrium at friction ", options.friction, " on the way");
      out.least_tipping = std::min(out.least_tipping, tipping_height(held.supports, at.centre_of_mass));
    }
  }
  return out;
}

StepVerdict judge_step(const Model& model, const terrain::Surface& surface, const Step& step, const Posture& before,
                       const CheckOptions& options) {
  judge_joints(model, before.joints, "the posture before");
  judge_joints(model, step.after.joints, "the posture after");
  const Stance from = judge_stance(surface, before, "the posture before");
  const Stance to = judge_stance(surface, step.after, "the posture after");
  const Skeleton at = skeleton(model, step.after.base, step.after.joints);
  const double stray = strayed(at, to, to.legs);
  if (stray > judge::kPoseTolerance) refuse("by its joints, a foot is ", stray, " m from where it stands");
  judge_clear(model, surface, step.after.base, at, to.legs, options.clearance, "the posture after");
  const double tipping = tipping_height(to.supports, at.centre_of_mass);
  if (!(tipping > 0.0)) refuse("the posture after tips over: NESM ", tipping, " m");
  if (!balanced(to.supports, at.centre_of_mass, options.friction))
    refuse("the posture after is not in equilibrium at friction ", options.friction);
  StepVerdict verdict{true, "", {}};
  verdict.margins.push_back({"NESM", tipping, 0.0, "m"});
  verdict.margins.push_back({"closure", judge::kPoseTolerance - stray, 0.0, "m"});
  if (!step.motion.empty()) {
    const Stance held = held_between(from, to);
    const double ends = std::min(tipping_height(held.supports, skeleton(model, before.base, before.joints).centre_of_mass),
                                 tipping_height(held.supports, at.centre_of_mass));
    const double demanded = std::min(options.least_nesm, ends);
    const Course course = judge_motion(model, surface, step, before, held, options);
    if (course.least_tipping < demanded - judge::kSame)
      refuse("the stability falls to a NESM of ", course.least_tipping, " m on the way, at least ", demanded, " m are demanded");
    verdict.margins.push_back({"slip between points", kSlip - course.slip, 0.0, "m"});
    verdict.margins.push_back({"least NESM on the way", course.least_tipping, demanded, "m"});
  }
  return verdict;
}

}  // namespace

StepVerdict check_step(const Model& model, const terrain::Surface& surface, const Step& step, const Posture& before,
                       const CheckOptions& options) {
  try {
    return judge_step(model, surface, step, before, options);
  } catch (const judge::Refusal& refusal) {
    return {false, refusal.reason, {}};
  }
}

}  // namespace foothold::hexpiderix
