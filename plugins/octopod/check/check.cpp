// One step: what is placed, how it stands, its equilibrium, its motion; margins.
#include "octopod/check/check.hpp"

#include <algorithm>

#include "contact/balance.hpp"
#include "octopod/check/course.hpp"
#include "octopod/check/itself.hpp"
#include "terrain/surface.hpp"

namespace foothold::octopod {
namespace {

// With stability off the friction left may be anything down to this: no friction may be enough.
constexpr double kMostFriction = 10.0;
constexpr double kLook = 0.1;  // m

// All that the robot can come near to between two postures: no point of it is farther from module A than two modules' lengths and a
// leg.
Eigen::AlignedBox3d region(const Model& model, const Step& step, const Posture& before) {
  Eigen::AlignedBox3d out(before.base.translation());
  out.extend(step.after.base.translation());
  for (const MotionPoint& point : step.motion) out.extend(point.base.translation());
  const double reach = 2.0 * model.arm() + model.body.norm() + model.shoulders[0].norm() + model.reach() + kLook;
  return {out.min() - Vector3d::Constant(reach), out.max() + Vector3d::Constant(reach)};
}

void judge_placed(const Step& step) {
  if (step.placed.size() != kLegs) refuse(step.placed.size(), " feet are placed, not ", kLegs);
  for (const Contact& contact : step.placed) {
    const auto held =
        std::find_if(step.after.stance.begin(), step.after.stance.end(), [&](const Contact& c) { return c.limb == contact.limb; });
    if (held == step.after.stance.end() || judge::error_between(held->frame, contact.frame) > judge::kSame)
      refuse("foot ", contact.limb, " does not stand where it is placed");
  }
}

StepVerdict judge_step(const Model& model, const terrain::Surface& surface, const Step& step, const Posture& before,
                       const CheckOptions& options) {
  for (const Posture* posture : {&before, &step.after})
    if (posture->joints.size() != kJoints) refuse("a posture gives ", posture->joints.size(), " joints, not ", kJoints);
  const std::vector<Triangle> triangles = triangles_in(surface.terrain(), region(model, step, before));
  const Setting setting{model, triangles, options};
  judge_placed(step);
  const Feet from = judge_feet(setting, before.stance, "the posture before");
  const Feet to = judge_feet(setting, step.after.stance, "the posture after");
  const Skeleton at = skeleton(model, step.after.base, step.after.joints);
  const double error = judge_closure(at, to, "the posture after");
  double clearance = judge_clear(setting, at, "the posture after");
  double apart = judge_apart(setting, at, "the posture after");

  const double needed =
      contact::least_friction(to, at.centre_of_mass, options.stability ? options.friction : kMostFriction, setting.cone());
  if (options.stability && !contact::balanced(to, at.centre_of_mass, options.friction, setting.cone()))
    refuse("the posture after is not in equilibrium at friction ", options.friction, "; it needs ",
           contact::least_friction(to, at.centre_of_mass, kMostFriction, setting.cone()), " (", kMostFriction, ": or more)");
  StepVerdict verdict{true, "", {}};
  if (options.transitions && step.motion.empty()) refuse("the step brings no motion");
  if (!step.motion.empty()) {
    const Course course = judge_course(setting, step, before, from, to);
    clearance = std::min(clearance, course.clearance);
    apart = std::min(apart, course.apart);
    verdict.margins.push_back({"slip between points", kSlip - course.slip, 0.0, "m"});
  }
  verdict.margins.push_back({options.stability ? "friction left" : "friction left, not demanded", options.friction - needed,
                             options.stability ? 0.0 : options.friction - kMostFriction, "1"});
  verdict.margins.push_back({"clearance", clearance, std::max(0.0, options.clearance - judge::kSame), "m"});
  verdict.margins.push_back({"legs and bodies apart", apart, std::max(0.0, options.clearance - judge::kSame), "m"});
  verdict.margins.push_back({"closure", judge::kPoseTolerance - error, 0.0, "m"});
  return verdict;
}

}  // namespace

StepVerdict check_step(const Model& model, const terrain::Surface& surface, const Step& step, const Posture& before,
                       const CheckOptions& options) {
  return judge::verdict_of([&] { return judge_step(model, surface, step, before, options); });
}

}  // namespace foothold::octopod
