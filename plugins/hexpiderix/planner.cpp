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
  const Start from = read_start(model_, ground_of(scene), read_options(parameters), request.start);
  return standing_posture(from.at, from.situation.footholds);
}

PlanReport HexpiderixPlanner::plan(const Request& request, const Parameters& parameters, const PreparedScene& scene,
                                   PlanContext& context) {
  const Options options = read_options(parameters);
  const Start from = read_start(model_, ground_of(scene), options, request.start);
  const auto begin = std::chrono::steady_clock::now();
  const Adaption found = adapt(model_, from.situation, options.adapt, context.stop);
  const double time = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  if (found.end == Adaption::End::kStopped) return stopped_report();
  if (found.end != Adaption::End::kFound) return failed_report(found);
  if (!context.emit(to_step(model_, from, found))) return stopped_report();
  return found_report(model_, found, from, options, time);
}

StepVerdict HexpiderixPlanner::check(const Step& step, const Posture& before, const Parameters& parameters,
                                     const PreparedScene& scene) const {
  const Options options = read_options(parameters);
  return check_step(model_, ground_of(scene).surface(), step, before, {options.clearance, options.adapt.best.friction});
}

std::vector<Shape> HexpiderixPlanner::shapes(const Posture& posture) const {
  return hexpiderix::shapes(model_, from_posture(posture));
}

}  // namespace foothold::hexpiderix
