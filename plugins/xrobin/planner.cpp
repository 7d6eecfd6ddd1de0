// Planner interface of Xrobin.
#include "planner.hpp"

#include <sstream>

#include "check.hpp"
#include "request.hpp"

namespace foothold::xrobin {
namespace {

class OpenPlane final : public PreparedScene {};

PlanReport stopped() {
  PlanReport report;
  report.outcome = PlanReport::Outcome::kStopped;
  return report;
}

}  // namespace

XrobinPlanner::XrobinPlanner(const RobotModel& model)
    : mechanism_(Mechanism::from_model(model)),
      ring_(mechanism_),
      bodies_(Bodies::from_model(model, mechanism_)),
      stroke_time_(model.number("piston.stroke_time", "s")),
      half_cycles_(mechanism_) {}

const PairSearch* XrobinPlanner::search(int cycles, const std::stop_token& stop) {
  if (const auto found = searches_.find(cycles); found != searches_.end()) return &found->second;
  if (!half_cycles_.grow(cycles, stop)) return nullptr;
  return &searches_.try_emplace(cycles, half_cycles_, cycles).first->second;
}

std::shared_ptr<const PreparedScene> XrobinPlanner::prepare(const Scene& scene, const Parameters& parameters) {
  if (!scene.path.empty()) throw InvalidScene("", "xrobin does not plan among obstacles yet");
  search(static_cast<int>(parameters.integer("cycles")), {});
  return std::make_shared<OpenPlane>();
}

Posture XrobinPlanner::start(const Request& request, const Parameters& parameters, const PreparedScene&) const {
  return posture(mechanism_, read_start(mechanism_, request.start, parameters));
}

PlanReport XrobinPlanner::plan(const Request& request, const Parameters& parameters, const PreparedScene&, PlanContext& context) {
  const Stance start = read_start(mechanism_, request.start, parameters);
  const Target goal = seen_from(start.a, read_goal(request.goal, parameters));
  const auto cycles = static_cast<int>(parameters.integer("cycles"));
  const double tolerance = parameters.real("tolerance");
  const PairSearch* pairs = search(cycles, context.stop);
  if (pairs == nullptr) return stopped();
  std::optional<Pair> best;
  for (double bound = 1e-3; !best && bound < 0.01; bound *= 2.0) {
    best = pairs->closest(goal, bound, context.stop);
    if (context.stop.stop_requested()) return stopped();
  }
  PlanReport report;
  if (!best) {
    report.error = PlanError::kUnreachableGoal;
    report.field = "goal.base";
    report.message = "no word of " + std::to_string(cycles) + " cycles ends within 8 mm of the goal";
    return report;
  }
  const Word word = pairs->word(*best);
  const PlanarPose goal_in_world = start.a * PlanarPose{goal.x, goal.y, 0.0};
  for (Step& step : to_steps(ring_, start, shortest_ways(start.configuration, word), 0, stroke_time_)) {
    step.cost = (step.after.base.translation() - Vector3d(goal_in_world.x, goal_in_world.y, 0.0)).norm();
    if (!context.emit(std::move(step))) return stopped();
  }
  const PlanarPose end = forward(mechanism_, word);
  report.cost = std::hypot(end.x - goal.x, end.y - goal.y);
  report.lower_bound = std::max(0.0, report.cost - pairs->merge_bound());
  report.optimal = true;
  report.cost_unit = "m";
  report.objective = "least distance of body A to the goal after at most " + std::to_string(cycles) + " cycles";
  report.figures = {{"distance_to_goal", report.cost, tolerance, "m"}};
  report.outcome = report.cost <= tolerance ? PlanReport::Outcome::kReached : PlanReport::Outcome::kPartial;
  if (report.outcome == PlanReport::Outcome::kPartial) {
    report.error = PlanError::kToleranceNotMet;
    report.field = "parameters.tolerance";
    std::ostringstream message;
    message << "the nearest end of " << cycles << " cycles is " << report.cost << " m away from the goal, " << tolerance
            << " m are allowed";
    report.message = message.str();
  }
  return report;
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
