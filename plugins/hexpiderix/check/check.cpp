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
  std::array<Vector3d, kLegs> points{}, normals{};
  std::vector<Support> supports;

  void add(std::size_t leg, const Support& support) {
    legs[leg] = true;
    points[leg] = support.point;
    normals[leg] = support.normal;
    supports.push_back(support);
  }
  Support support(std::size_t leg) const { return {points[leg], normals[leg]}; }
};

Stance judge_stance(const terrain::Surface& surface, const Posture& posture, const char* which) {
  Stance out;
  for (const Contact& contact : posture.stance) {
    std::size_t leg = 0;
    while (leg < kLegs && contact.limb != "L" + std::to_string(leg + 1)) ++leg;
    if (leg == kLegs) refuse(which, ": '", contact.limb, "' is no leg");
    if (out.legs[leg]) refuse(which, ": ", contact.limb, " stands twice");
    const Vector3d point = contact.frame.translation(), up = contact.frame.linear().col(2);
    const Vector3d* normal = normal_at(surface, point, up, judge::kPoseTolerance);
    if (normal == nullptr) refuse(which, ": foot ", contact.limb, " is ", surface.nearest(point).distance, " m off the ground");
    if ((*normal - up).norm() > judge::kPoseTolerance)
      refuse(which, ": the contact of ", contact.limb, " is not along the ground's normal");
    out.add(leg, {point, *normal});
  }
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

// How far the farthest of some feet is from its place by the legs' kinematics.
double strayed(const Skeleton& at, const Stance& stance) {
  double most = 0.0;
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    if (stance.legs[leg]) most = std::max(most, (at.limbs[leg].foot - stance.points[leg]).norm());
  return most;
}

// What is placed stands, and what stands anew is placed.
void judge_placed(const Step& step, const Posture& before) {
  const auto among = [](const std::vector<Contact>& all, const Contact& wanted) {
    return std::any_of(all.begin(), all.end(), [&](const Contact& c) {
      return c.limb == wanted.limb && judge::error_between(c.frame, wanted.frame) <= judge::kSame;
    });
  };
  for (const Contact& contact : step.placed)
    if (!among(step.after.stance, contact)) refuse("foot ", contact.limb, " does not stand where it is placed");
  for (const Contact& contact : step.after.stance) {
    const bool stays = std::any_of(before.stance.begin(), before.stance.end(), [&](const Contact& c) {
      return c.limb == contact.limb && judge::apart(c.frame, contact.frame) <= judge::kSame;
    });
    if (!stays && !among(step.placed, contact)) refuse("foot ", contact.limb, " stands where it is not placed");
  }
}

struct Instant {
  Isometry3d base;
  std::vector<double> joints;
};

Instant between(const MotionPoint& a, const MotionPoint& b, double part) {
  Instant out{a.base, a.joints};
  out.base.translation() += part * (b.base.translation() - a.base.translation());
  out.base.linear() = Eigen::Quaterniond(a.base.linear()).slerp(part, Eigen::Quaterniond(b.base.linear())).toRotationMatrix();
  for (std::size_t j = 0; j < out.joints.size(); ++j) out.joints[j] += part * (b.joints[j] - a.joints[j]);
  return out;
}

// The feet that carry from one point of a motion to the next: those that are on a foothold of either posture at both.
Stance carrying(const Skeleton& a, const Skeleton& b, const Stance& from, const Stance& to) {
  Stance out;
  const auto stays = [&](const Stance& stance, std::size_t leg) {
    return stance.legs[leg] && (a.limbs[leg].foot - stance.points[leg]).norm() <= judge::kPoseTolerance &&
           (b.limbs[leg].foot - stance.points[leg]).norm() <= judge::kPoseTolerance;
  };
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    for (const Stance* stance : {&from, &to}) {
      if (out.legs[leg] || !stays(*stance, leg)) continue;
      out.add(leg, stance->support(leg));
    }
  return out;
}

struct Course {
  double slip = 0.0;           // m
  double least_tipping = 0.0;  // m, from where the robot first stands stably
  bool stable = false;         // ever
};

void judge_ends(const Model& model, const Step& step, const Posture& before) {
  const auto off = [](const MotionPoint& point, const Posture& posture) {
    double most = judge::error_between(point.base, posture.base);
    for (std::size_t k = 0; k < posture.joints.size(); ++k) most = std::max(most, std::abs(point.joints[k] - posture.joints[k]));
    return most;
  };
  for (const MotionPoint& point : step.motion) judge_joints(model, point.joints, "a point of the motion");
  if (std::abs(step.motion.front().time) > judge::kSame) refuse("the motion begins at ", step.motion.front().time, " s, not at 0");
  if (off(step.motion.front(), before) > judge::kPoseTolerance) refuse("the motion does not begin at the posture before");
  if (off(step.motion.back(), step.after) > judge::kPoseTolerance) refuse("the motion does not end at the posture after");
}

void judge_speed(const Model& model, const MotionPoint& a, const MotionPoint& b) {
  double fastest = 0.0;
  for (std::size_t j = 0; j < a.joints.size(); ++j) fastest = std::max(fastest, std::abs(b.joints[j] - a.joints[j]));
  if (b.time < a.time) refuse("the motion's time runs back from ", a.time, " to ", b.time, " s");
  if (fastest > model.joint_speed * (b.time - a.time) + judge::kPoseTolerance)
    refuse("the motion turns a joint by ", fastest, " rad in ", b.time - a.time, " s");
}

Course judge_motion(const Model& model, const terrain::Surface& surface, const Step& step, const Stance& from, const Stance& to,
                    bool demand_balance, const CheckOptions& options) {
  Course out{0.0, std::numeric_limits<double>::infinity(), false};
  Legs carried;
  for (std::size_t k = 1; k < step.motion.size(); ++k) {
    const MotionPoint &a = step.motion[k - 1], &b = step.motion[k];
    judge_speed(model, a, b);
    const Stance feet = carrying(skeleton(model, a.base, a.joints), skeleton(model, b.base, b.joints), from, to);
    for (std::size_t leg = 0; leg < kLegs; ++leg) {
      const bool stays = from.legs[leg] && to.legs[leg] && (from.points[leg] - to.points[leg]).norm() <= judge::kSame;
      if (stays && !feet.legs[leg]) refuse("supporting foot L", leg + 1, " strays at ", b.time, " s");
    }
    if (feet.legs.count() < 3) refuse("only ", feet.legs.count(), " feet hold at ", b.time, " s");
    for (int look = feet.legs == carried ? 1 : 0; look <= kBetween; ++look) {
      const Instant now = between(a, b, static_cast<double>(look) / kBetween);
      const Skeleton at = skeleton(model, now.base, now.joints);
      const double stray = strayed(at, feet);
      out.slip = std::max(out.slip, stray);
      if (stray > kSlip) refuse("a supporting foot strays by ", stray, " m on the way");
      judge_clear(model, surface, now.base, at, feet.legs, options.clearance, "on the way");
      if (demand_balance && look % kBetween == 0 && !balanced(feet.supports, at.centre_of_mass, options.friction))
        refuse("the feet that hold are not in equilibrium at friction ", options.friction, " on the way");
      const double tipping = tipping_height(feet.supports, at.centre_of_mass);
      out.stable = out.stable || tipping > 0.0;
      if (out.stable) out.least_tipping = std::min(out.least_tipping, tipping);
    }
    carried = feet.legs;
  }
  return out;
}

StepVerdict judge_step(const Model& model, const terrain::Surface& surface, const Step& step, const Posture& before,
                       const CheckOptions& options) {
  judge_joints(model, before.joints, "the posture before");
  judge_joints(model, step.after.joints, "the posture after");
  const Stance from = judge_stance(surface, before, "the posture before");
  const Stance to = judge_stance(surface, step.after, "the posture after");
  judge_placed(step, before);
  const Skeleton at = skeleton(model, step.after.base, step.after.joints);
  const double stray = strayed(at, to);
  if (!(stray <= judge::kPoseTolerance)) refuse("by its joints, a foot is ", stray, " m from where it stands");
  judge_clear(model, surface, step.after.base, at, to.legs, options.clearance, "the posture after");
  const double tipping = tipping_height(to.supports, at.centre_of_mass);
  if (!(tipping > 0.0)) refuse("the posture after tips over: NESM ", tipping, " m");
  if (!balanced(to.supports, at.centre_of_mass, options.friction))
    refuse("the posture after is not in equilibrium at friction ", options.friction);
  StepVerdict verdict{true, "", {}};
  verdict.margins.push_back({"NESM", tipping, 0.0, "m"});
  verdict.margins.push_back({"closure", judge::kPoseTolerance - stray, 0.0, "m"});
  if (!step.motion.empty()) {
    judge_ends(model, step, before);
    // A robot that begins out of balance may come into it, and then it keeps it.
    const Vector3d begin = skeleton(model, before.base, before.joints).centre_of_mass;
    const bool have_it = std::min(tipping_height(from.supports, begin), tipping) >= options.least_nesm;
    const double demanded = have_it && from.legs == to.legs ? options.least_nesm : 0.0;
    const Course course = judge_motion(model, surface, step, from, to, balanced(from.supports, begin, options.friction), options);
    if (course.stable && !(course.least_tipping >= demanded - judge::kSame))
      refuse("the stability falls to a NESM of ", course.least_tipping, " m on the way, at least ", demanded, " m are demanded");
    verdict.margins.push_back({"slip between points", kSlip - course.slip, 0.0, "m"});
    if (course.stable) verdict.margins.push_back({"least NESM on the way", course.least_tipping, demanded - judge::kSame, "m"});
  }
  return verdict;
}

}  // namespace

StepVerdict check_step(const Model& model, const terrain::Surface& surface, const Step& step, const Posture& before,
                       const CheckOptions& options) {
  return judge::verdict_of([&] { return judge_step(model, surface, step, before, options); });
}

}  // namespace foothold::hexpiderix
