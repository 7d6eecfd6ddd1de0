// Planner interface of the octopod.
#include "octopod/planner.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "octopod/check/check.hpp"
#include "octopod/report.hpp"
#include "octopod/steps.hpp"
#include "octopod/transition/transition.hpp"
#include "terrain/terrain.hpp"

namespace foothold::octopod {
namespace {

constexpr double kRrtShare = 0.8;  // of the budget; the rest is for motions and for sending

const Ground& ground_of(const PreparedScene& scene) { return dynamic_cast<const Ground&>(scene); }

// With the terrain that it looks at.
std::shared_ptr<const terrain::Surface> read_surface(const Scene& scene) {
  if (scene.path.empty()) throw InvalidScene("scene", "the octopod walks on a terrain; the request names no scene");
  struct Owned {
    explicit Owned(terrain::Terrain read) : terrain(std::move(read)), surface(terrain) {}
    terrain::Terrain terrain;
    terrain::Surface surface;
  };
  auto owned = std::make_shared<const Owned>(terrain::read_terrain(scene.path));
  return {owned, &owned->surface};
}

double since(std::chrono::steady_clock::time_point then) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - then).count();
}

Route search(const Ground& ground, const Options& options, State from, int goal, PlanContext& context) {
  if (options.method == Method::kPaper) return paper_route(ground, from, goal, options.route, context.stop);
  Edge edge;
  if (options.transitions)
    edge = [&](State a, State b) {
      if (const auto known = ground.passage(a, b)) return *known;
      const bool open = has_transitions(ground, ground.standing(a).standing, ground.standing(b).standing, options.swing_height);
      ground.keep_passage(a, b, open);
      return open;
    };
  if (options.method == Method::kRrt) return rrt_route(ground, from, goal, options.route, context.random, context.stop, edge);
  return optimal_route(ground, from, goal, options.route, edge, context.stop);
}

}  // namespace

OctopodPlanner::OctopodPlanner(const RobotModel& model) : model_(Model::from_model(model)) {}

std::shared_ptr<const PreparedScene> OctopodPlanner::prepare(const Scene& scene, const Parameters& parameters) {
  return std::make_shared<Ground>(model_, read_surface(scene), read_options(parameters).ground);
}

Posture OctopodPlanner::start(const Request& request, const Parameters& parameters, const PreparedScene& scene) const {
  const Ground& ground = ground_of(scene);
  const State state = read_start(ground, read_options(parameters), request);
  return standing_posture(ground.standing(state).standing);
}

PlanReport OctopodPlanner::plan(const Request& request, const Parameters& parameters, const PreparedScene& scene,
                                PlanContext& context) {
  const Ground& ground = ground_of(scene);
  Options options = read_options(parameters);
  options.route.budget = kRrtShare * request.budget;
  const State from = read_start(ground, options, request);
  const int goal = read_goal(ground, options, request.goal);

  const auto begin = std::chrono::steady_clock::now();
  const Route route = search(ground, options, from, goal, context);
  if (route.end == Route::End::kStopped) return stopped_report();
  if (route.end != Route::End::kFound || route.penalised > 0) return failed_report(options, route, goal);

  Course course;
  course.search_time = since(begin);
  course.goal_distance = (ground.place(goal) - request.goal.base->translation()).norm();
  course.least_margin = ground.options().friction;
  const auto send = [&](Step step, const Transition* way) {
    if (way != nullptr) {
      const auto then = std::chrono::steady_clock::now();
      step.motion = to_motion(model_, *way);
      course.least_margin = std::min(course.least_margin, way->least_margin);
      course.motion_time += since(then);
    }
    return context.emit(std::move(step));
  };
  for (std::size_t k = 1; k < route.states.size(); ++k) {
    if (context.stop.stop_requested()) return stopped_report();
    std::vector<Transition> parts;
    if (options.transitions) {
      const auto then = std::chrono::steady_clock::now();
      parts = transitions(ground, ground.standing(route.states[k - 1]).standing, ground.standing(route.states[k]).standing,
                          options.swing_height);
      if (parts.empty())
        throw std::logic_error("a transition of the route that was found is missing: step " + std::to_string(k - 1));
      course.motion_time += since(then);
    }
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
      const double part = static_cast<double>(i + 1) / static_cast<double>(parts.size());
      Step stop = to_stop(ground, parts[i].to, route.states[k], std::lerp(route.costs[k - 1], route.costs[k], part));
      if (!send(std::move(stop), &parts[i])) return stopped_report();
    }
    if (!send(to_step(ground, route.states[k], route.costs[k]), parts.empty() ? nullptr : &parts.back())) return stopped_report();
  }
  return found_report(ground, options, route, course);
}

StepVerdict OctopodPlanner::check(const Step& step, const Posture& before, const Parameters& parameters,
                                  const PreparedScene& scene) const {
  return check_step(model_, ground_of(scene).surface(), step, before, check_options(read_options(parameters)));
}

std::vector<Shape> OctopodPlanner::shapes(const Posture& posture) const { return octopod::shapes(model_, from_posture(posture)); }

}  // namespace foothold::octopod
