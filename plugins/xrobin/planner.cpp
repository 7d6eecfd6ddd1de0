// Planner interface of Xrobin.
#include "planner.hpp"

#include "check.hpp"
#include "report.hpp"
#include "request.hpp"

namespace foothold::xrobin {
namespace {

class OpenPlane final : public PreparedScene {};

Method method_of(const Parameters& parameters) {
  const std::string& name = parameters.text("method");
  if (name == "fewest") return Method::kFewest;
  if (name == "greedy") return Method::kGreedy;
  if (name == "brute_force") return Method::kBruteForce;
  return Method::kOptimal;
}

Limits limits_of(const Parameters& parameters) {
  return {static_cast<int>(parameters.integer("cycles")), static_cast<int>(parameters.integer("max_cycles")),
          parameters.real("tolerance"), parameters.flag("early_stop")};
}

void demand_sense(Method method, const Target& goal, const Limits& limits) {
  if (method == Method::kGreedy && goal.heading)
    throw InvalidRequest("goal.any_orientation",
                         "method greedy plans for a position only; set any_orientation, or take another method");
  if (method == Method::kBruteForce && limits.cycles > kMostBruteForceCycles)
    throw InvalidRequest("parameters.cycles",
                         "method brute_force takes " + std::to_string(kMostBruteForceCycles) + " cycles at most");
}

}  // namespace

XrobinPlanner::XrobinPlanner(const RobotModel& model)
    : mechanism_(Mechanism::from_model(model)),
      ring_(mechanism_),
      bodies_(Bodies::from_model(model, mechanism_)),
      stroke_time_(model.number("piston.stroke_time", "s")),
      solver_(mechanism_) {}

std::shared_ptr<const PreparedScene> XrobinPlanner::prepare(const Scene& scene, const Parameters& parameters) {
  if (!scene.path.empty()) throw InvalidScene("", "xrobin does not plan among obstacles yet");
  solver_.prepare(method_of(parameters), limits_of(parameters).cycles, static_cast<int>(parameters.integer("grid_cells")), {});
  return std::make_shared<OpenPlane>();
}

Posture XrobinPlanner::start(const Request& request, const Parameters& parameters, const PreparedScene&) const {
  return posture(mechanism_, read_start(mechanism_, request.start, parameters));
}

PlanReport XrobinPlanner::plan(const Request& request, const Parameters& parameters, const PreparedScene&, PlanContext& context) {
  const Stance start = read_start(mechanism_, request.start, parameters);
  const Target in_world = read_goal(request.goal, parameters);
  const Target goal = seen_from(start.a, in_world);
  const Method method = method_of(parameters);
  const Limits limits = limits_of(parameters);
  demand_sense(method, goal, limits);
  if (!solver_.prepare(method, limits.cycles, static_cast<int>(parameters.integer("grid_cells")), context.stop))
    return stopped_report();
  const Solution solution = solver_.solve(method, goal, limits, context.stop);
  if (solution.stopped) return stopped_report();
  std::size_t half = 0;
  for (Step& step : to_steps(ring_, start, shortest_ways(start.configuration, solution.word), 0, stroke_time_)) {
    const Vector3d at = step.after.base.translation();
    step.cost =
        method == Method::kFewest ? static_cast<double>(half++ / 2 + 1) : std::hypot(at.x() - in_world.x, at.y() - in_world.y);
    if (!context.emit(std::move(step))) return stopped_report();
  }
  return report_of(method, goal, limits, mechanism_, solution);
}

StepVerdict XrobinPlanner::check(const Step& step, const Posture& before, const Parameters&, const PreparedScene&) const {
  return check_step(mechanism_.lengths(), step, before);
}

std::vector<Shape> XrobinPlanner::shapes(const Posture& posture) const {
  BodyPoses poses;
  for (const Contact& contact : posture.stance) (contact.limb == "A" ? poses.a : poses.b) = body_of_contact(contact.frame);
  return solids(bodies_, mechanism_.lengths(), poses);
}

}  // namespace foothold::xrobin
