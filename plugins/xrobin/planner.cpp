// Planner interface of Xrobin.
#include "planner.hpp"

#include <algorithm>
#include <stdexcept>

#include "check.hpp"
#include "geometry/walls.hpp"
#include "obstacle_solver.hpp"
#include "report.hpp"
#include "request.hpp"

namespace foothold::xrobin {
namespace {

// What is kept of a scene: its obstacles with the robot's clearance.
class PreparedPlane final : public PreparedScene {
 public:
  explicit PreparedPlane(Surroundings surroundings) : surroundings_(std::move(surroundings)) {}
  const Surroundings& surroundings() const { return surroundings_; }

  // Each obstacle as high as the robot, whatever its own height: Xrobin goes over none.
  std::vector<Shape> shapes() const override {
    const Bodies& robot = surroundings_.bodies();
    const double height = std::max(robot.a.height, robot.b.height) + 2.0 * robot.piston_radius;
    std::vector<Shape> out;
    for (const geometry::Obstacle& obstacle : surroundings_.obstacles()) {
      const std::vector<Shape> walls = geometry::walls_of(obstacle, height);
      out.insert(out.end(), walls.begin(), walls.end());
    }
    return out;
  }

 private:
  Surroundings surroundings_;
};

const Surroundings& surroundings_of(const PreparedScene& scene) { return dynamic_cast<const PreparedPlane&>(scene).surroundings(); }

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

bool XrobinPlanner::make_tables(const Parameters& parameters, bool obstacles, const std::stop_token& stop) {
  return solver_.prepare(method_of(parameters), limits_of(parameters).cycles, static_cast<int>(parameters.integer("grid_cells")),
                         obstacles, stop);
}

std::shared_ptr<const PreparedScene> XrobinPlanner::prepare(const Scene& scene, const Parameters& parameters) {
  std::vector<geometry::Obstacle> obstacles;
  if (!scene.path.empty()) {
    if (scene.format != "yaml") throw InvalidScene("", "xrobin takes plane scenes in yaml, not " + scene.format);
    obstacles = geometry::read_plane_scene(scene.path).obstacles;
  }
  make_tables(parameters, !obstacles.empty(), {});
  return std::make_shared<PreparedPlane>(Surroundings(ring_, bodies_, std::move(obstacles), parameters.real("clearance")));
}

Posture XrobinPlanner::start(const Request& request, const Parameters& parameters, const PreparedScene& scene) const {
  const Stance stance = read_start(mechanism_, request.start, parameters);
  const Surroundings& surroundings = surroundings_of(scene);
  const auto nearest = surroundings.nearest({stance.a, stance.a * mechanism_.b_in_a(stance.configuration)});
  if (nearest.distance <= surroundings.clearance())
    throw InvalidRequest(request.start.contacts.empty() ? "start.base" : "start.contacts",
                         "the robot stands " + std::to_string(nearest.distance) + " m away from obstacle '" +
                             surroundings.obstacles()[nearest.obstacle].name + "', " + std::to_string(surroundings.clearance()) +
                             " m must be kept");
  return posture(mechanism_, stance);
}

PlanReport XrobinPlanner::plan(const Request& request, const Parameters& parameters, const PreparedScene& scene,
                               PlanContext& context) {
  const Stance start_stance = read_start(mechanism_, request.start, parameters);
  const Target in_world = read_goal(request.goal, parameters);
  const Target goal = seen_from(start_stance.a, in_world);
  const Method method = method_of(parameters);
  const Limits limits = limits_of(parameters);
  demand_sense(method, goal, limits);
  const Surroundings& surroundings = surroundings_of(scene);
  const bool obstacles = !surroundings.obstacles().empty();
  if (!make_tables(parameters, obstacles, context.stop)) return stopped_report();

  Solution solution;
  Route route;
  if (obstacles) {
    start(request, parameters, scene);
    const ObstacleLimits obstacle_limits{static_cast<std::size_t>(parameters.integer("max_pairs")),
                                         static_cast<std::size_t>(parameters.integer("max_nodes"))};
    Passage passage(surroundings, context.stop);
    solution = ObstacleSolver(solver_, passage, start_stance, in_world, limits, obstacle_limits, context.stop).solve(method);
    if (solution.stopped) return stopped_report();
    const std::optional<Route> clear = clear_ways(mechanism_, passage, start_stance, solution.word);
    if (!clear && passage.stopped()) return stopped_report();
    if (!clear) throw std::logic_error("a half cycle of the plan that was found is blocked");
    route = *clear;
  } else {
    solution = solver_.solve(method, goal, limits, context.stop);
    if (solution.stopped) return stopped_report();
    route = shortest_ways(start_stance.configuration, solution.word);
  }
  std::size_t half = 0;
  for (Step& step : to_steps(ring_, start_stance, route, 0, stroke_time_)) {
    const Vector3d at = step.after.base.translation();
    step.cost =
        method == Method::kFewest ? static_cast<double>(half++ / 2 + 1) : std::hypot(at.x() - in_world.x, at.y() - in_world.y);
    if (!context.emit(std::move(step))) return stopped_report();
  }
  return report_of(method, goal, limits, mechanism_, solution);
}

StepVerdict XrobinPlanner::check(const Step& step, const Posture& before, const Parameters&, const PreparedScene& scene) const {
  const Surroundings& surroundings = surroundings_of(scene);
  return check_step_among(mechanism_.lengths(), bodies_, surroundings.obstacles(), surroundings.clearance(), step, before);
}

std::vector<Shape> XrobinPlanner::shapes(const Posture& posture) const {
  BodyPoses poses;
  for (const Contact& contact : posture.stance) (contact.limb == "A" ? poses.a : poses.b) = body_of_contact(contact.frame);
  return solids(bodies_, mechanism_.lengths(), poses);
}

}  // namespace foothold::xrobin
