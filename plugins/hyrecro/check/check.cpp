#include "hyrecro/check/check.hpp"

#include "hyrecro/check/clear.hpp"
#include "hyrecro/check/closure.hpp"
#include "hyrecro/check/on_face.hpp"
#include "hyrecro/check/path.hpp"
#include "hyrecro/check/refusal.hpp"

namespace foothold::hyrecro {
namespace {

StepVerdict judge(const Model& model, const truss::Truss& truss, const Obstacles& obstacles, const CheckOptions& options,
                  const Step& step, const Posture& before) {
  const Stances stances = judge_stances(step, before);
  const std::string where = "the posture after";
  double reach = judge_limits(model, step.after.joints, where);
  const Setting setting{model, truss, obstacles, options, stances.holds, stances.held->frame};
  const Posed after = posed(model, step.after.joints, setting.holds, setting.held);
  judge_base(after, step.after.base, where);
  const double error = judge_contact(after, *stances.placed, where);
  const double on_face = judge_on_face(model, truss, *stances.placed);
  Clearance least;
  judge_clear(setting, after.coordinates, where, least);
  if (!step.motion.empty()) reach = std::min(reach, judge_path(setting, stances, step, before, least));
  const double clearance = options.clearance;
  return {true,
          "",
          {{"reach", reach, -kSame, "m"},
           {"clearance", least.scene, clearance, "m"},
           {"self clearance", least.itself, clearance, "m"},
           {"plate on face", on_face, -kPoseTolerance, "m"},
           {"closure", kPoseTolerance - error, 0.0, "m"}}};
}

}  // namespace

StepVerdict check_step(const Model& model, const truss::Truss& truss, const Obstacles& obstacles, const CheckOptions& options,
                       const Step& step, const Posture& before) {
  try {
    return judge(model, truss, obstacles, options, step, before);
  } catch (const Refusal& refusal) {
    return {false, refusal.reason, {}};
  }
}

}  // namespace foothold::hyrecro
