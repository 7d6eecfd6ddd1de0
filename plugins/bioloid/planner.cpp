// Planner interface of Bioloid.
#include "bioloid/planner.hpp"

#include <chrono>

#include "bioloid/check/check.hpp"
#include "bioloid/report.hpp"
#include "bioloid/sending.hpp"

namespace foothold::bioloid {
namespace {

const Ground& ground_of(const PreparedScene& scene) { return dynamic_cast<const Ground&>(scene); }

PlanReport refused_goal(const std::string& reason) {
  PlanReport report;
  report.error = PlanError::kUnreachableGoal;
  report.field = "goal.base.position";
  report.message = reason;
  report.hint = "move the goal away from the obstacle";
  return report;
}

}  // namespace

BioloidPlanner::BioloidPlanner(const RobotModel& model) : model_(Model::from_model(model)) {}

std::shared_ptr<const PreparedScene> BioloidPlanner::prepare(const Scene& scene, const Parameters&) {
  return scene.path.empty() ? std::make_shared<Ground>() : std::make_shared<Ground>(scene.path);
}

Posture BioloidPlanner::start(const Request& request, const Parameters& parameters, const PreparedScene& scene) const {
  const Stand stand = read_start(model_, read_options(parameters), ground_of(scene), request.start);
  return standing_posture(model_, stand.feet, stand.joints);
}

PlanReport BioloidPlanner::plan(const Request& request, const Parameters& parameters, const PreparedScene& scene,
                                PlanContext& context) {
  const Options options = read_options(parameters);
  const Ground& ground = ground_of(scene);
  const Stand from = read_start(model_, options, ground, request.start);
  const FootstepGoal goal = read_goal(model_, request.goal);
  const auto begin = std::chrono::steady_clock::now();
  Gait gait(model_, options.gait);
  Walker walker(model_, gait, options.walk, ground.prisms());
  if (!goal.any_heading)
    for (const Side side : {Side::kRight, Side::kLeft})
      if (const std::string reason = walker.refusal(side, sole_at(side, goal.base, walker.half_spacing())); !reason.empty())
        return refused_goal(reason);

  Joints joints = from.joints;
  std::optional<Phase> rise;
  if (!from.midway) {
    rise = gait.rise(from.joints, Side::kRight, rounded(relative(from.feet.right, from.feet.left)));
    if (!rise) {
      PlanReport report = refused_goal(
          "from the joints given the robot does not get to the posture in which it walks without leaving balance or limits");
      report.error = PlanError::kNoPath;
      report.field = "start.joints";
      report.hint = "start nearer to that posture: leave start.joints out to see it";
      return report;
    }
    joints = rise->points.back();
  }
  const Walk found = walker.walk(from.feet, goal, context.random, context.stop);
  const double time = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  if (found.end == Walk::End::kStopped) return stopped_report();
  if (found.end != Walk::End::kFound) return failed_report(found, options);
  if (rise && !context.emit(to_step(model_, from, *rise))) return stopped_report();
  Feet feet = from.feet;
  int number = 0;
  for (const WalkStep& step : found.steps) {
    if (!context.emit(to_step(model_, feet, joints, step, ++number))) return stopped_report();
    feet = step.after;
  }
  return walked_report(model_, found, from, options, gait.paper_figures(), time);
}

StepVerdict BioloidPlanner::check(const Step& step, const Posture& before, const Parameters& parameters,
                                  const PreparedScene& scene) const {
  const Options options = read_options(parameters);
  CheckOptions demands;
  demands.clearance = options.gait.demands.clearance;
  demands.balance = options.gait.demands.balance;
  return check_step(model_, ground_of(scene).prisms(), step, before, demands);
}

std::vector<Shape> BioloidPlanner::shapes(const Posture& posture) const { return bioloid::shapes(model_, from_posture(posture)); }

}  // namespace foothold::bioloid
