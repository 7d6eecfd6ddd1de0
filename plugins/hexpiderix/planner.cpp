// Planner interface of Hex-piderix.
#include "hexpiderix/planner.hpp"

#include <chrono>

#include "hexpiderix/check/check.hpp"
#include "hexpiderix/report.hpp"
#include "hexpiderix/steps.hpp"

namespace foothold::hexpiderix {
namespace {

const Ground& ground_of(const PreparedScene& scene) { return dynamic_cast<const Ground&>(scene); }

}  // namespace

HexpiderixPlanner::HexpiderixPlanner(const RobotModel& model) : model_(Model::from_model(model)) {}

std::shared_ptr<const PreparedScene> HexpiderixPlanner::prepare(const Scene& scene, const Parameters&) {
  if (scene.path.empty()) throw InvalidScene("scene", "Hex-piderix stands on a terrain; the request names no scene");
  return std::make_shared<Ground>(terrain::read_terrain(scene.path));
}

Posture HexpiderixPlanner::start(const Request& request, const Parameters& parameters, const PreparedScene& scene) const {
  const Options options = read_options(parameters);
  if (is_walk(request)) {
    const Stand stand = read_stand(model_, ground_of(scene), options, request.start);
    return standing_posture(stand.at, stand.feet);
  }
  const Start from = read_start(model_, ground_of(scene), options, request.start);
  return standing_posture(from.at, from.situation.footholds);
}

PlanReport HexpiderixPlanner::plan(const Request& request, const Parameters& parameters, const PreparedScene& scene,
                                   PlanContext& context) {
  const Options options = read_options(parameters);
  if (is_walk(request)) return plan_walk(request, options, ground_of(scene), context);
  const Start from = read_start(model_, ground_of(scene), options, request.start);
  const auto begin = std::chrono::steady_clock::now();
  const Adaption found = adapt(model_, from.situation, options.adapt, context.stop);
  const double time = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  if (found.end == Adaption::End::kStopped) return stopped_report();
  if (found.end != Adaption::End::kFound) return failed_report(found);
  if (!context.emit(to_step(model_, from, found))) return stopped_report();
  return found_report(model_, found, from, options, time);
}

PlanReport HexpiderixPlanner::plan_walk(const Request& request, const Options& options, const Ground& ground,
                                        PlanContext& context) const {
  const Stand from = read_stand(model_, ground, options, request.start);
  const Station goal = read_goal(ground, options, from, request.goal);
  const auto begin = std::chrono::steady_clock::now();
  const Walk found = walk(model_, ground, from, goal, options.walk, context.stop);
  const double time = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  if (found.end == Walk::End::kStopped) return stopped_report();
  if (found.end == Walk::End::kBlocked) return blocked_report(found);
  const Stand* at = &from;
  double way = 0.0;
  int number = 0;
  for (const HalfCycle& half_cycle : found.half_cycles) {
    way += (half_cycle.to.at.thorax.translation() - at->at.thorax.translation()).norm();
    if (!context.emit(to_step(model_, *at, half_cycle, ++number, way))) return stopped_report();
    at = &half_cycle.to;
  }
  return walked_report(model_, found, from, goal, options, time);
}

StepVerdict HexpiderixPlanner::check(const Step& step, const Posture& before, const Parameters& parameters,
                                     const PreparedScene& scene) const {
  const Options options = read_options(parameters);
  return check_step(model_, ground_of(scene).surface(), step, before,
                    {options.clearance, options.adapt.best.friction, options.walk.least_nesm});
}

std::vector<Shape> HexpiderixPlanner::shapes(const Posture& posture) const {
  return hexpiderix::shapes(model_, from_posture(posture));
}

}  // namespace foothold::hexpiderix
