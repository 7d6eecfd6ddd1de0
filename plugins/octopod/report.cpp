// Costs, proofs and reasons.
#include "octopod/report.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace foothold::octopod {
namespace {

// Figures must be finite; what no friction holds is told as this much.
constexpr double kNoFriction = 1000.0;

template <class... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream out;
  (out << ... << parts);
  return out.str();
}

std::string objective(const Options& options) {
  const std::string cost = text("way between nodes and ", options.route.posture_weight, " times the change of posture");
  switch (options.method) {
    case Method::kOptimal:
      return text("least sum of ", cost, ", over all routes of ", options.route.stability ? "stable " : "",
                  "nodes and orientations", options.transitions ? " joined by transitions" : "",
                  options.route.stability ? "" : "; STABILITY IS OFF");
    case Method::kPaper:
      return text("sum of ", cost, ", small by the paper's A* over nodes", options.route.stability ? "" : "; STABILITY IS OFF");
    case Method::kRrt:
      break;
  }
  return text("sum of ", cost, ", small by RRT*", options.route.stability ? "" : "; STABILITY IS OFF");
}

}  // namespace

PlanReport found_report(const Ground& ground, const Options& options, const Route& route, const Course& course) {
  PlanReport report;
  report.outcome = PlanReport::Outcome::kReached;
  report.cost = route.cost;
  report.lower_bound = std::min(route.bound, route.cost);
  report.optimal = route.optimal && report.cost - report.lower_bound <= 1e-9 * std::max(1.0, report.cost);
  report.cost_unit = "m";
  report.objective = objective(options);

  double way = 0.0, worst_friction = 0.0, residual = 0.0, slope = 0.0;
  int unstable = 0;
  for (std::size_t k = 0; k < route.states.size(); ++k) {
    const State state = route.states[k];
    const int node = node_of(state);
    if (k > 0) way += (ground.place(node) - ground.place(node_of(route.states[k - 1]))).norm();
    worst_friction = std::max(worst_friction, std::min(kNoFriction, ground.critical_friction(state)));
    residual = std::max(residual, ground.standing(state).standing.residual);
    slope = std::max(slope, std::acos(std::clamp(ground.normal(node).z(), -1.0, 1.0)));
    if (!ground.stable(state)) ++unstable;
  }
  if (unstable > 0)
    report.message =
        text("NOT SAFE: ", unstable, " of ", route.states.size(), " stances are unstable at friction ", options.ground.friction);
  const auto add = [&](const char* name, double value, double bound, const char* unit) {
    report.figures.push_back({name, value, bound, unit});
  };
  add("way", way, 0.0, "m");
  add("posture change", route.cost - way, 0.0, "m");
  add("distance to goal", course.goal_distance, 0.0, "m");
  add("greatest critical friction", worst_friction, options.ground.friction, "1");
  if (options.transitions) add("least friction left in motion", course.least_margin, 0.0, "1");
  add("unstable stances", unstable, 0.0, "1");
  add("steepest node", slope, 0.0, "rad");
  add("greatest residual", residual, 0.0, "m");
  add("states expanded", static_cast<double>(route.expanded), 0.0, "1");
  add("postures made", static_cast<double>(route.postures), 0.0, "1");
  add("search", course.search_time, 0.0, "ms");
  if (options.transitions) add("motion", course.motion_time, 0.0, "ms");
  return report;
}

PlanReport failed_report(const Options& options, const Route& route, int goal) {
  PlanReport report;
  report.outcome = PlanReport::Outcome::kFailed;
  if (route.end == Route::End::kExhausted) {
    report.error = PlanError::kSearchLimit;
    if (options.method == Method::kRrt) {
      report.field = "parameters.samples";
      report.message = text("RRT* found no route with ", route.expanded, " samples; that does not prove that there is none");
      report.hint = "raise samples or the budget, or take method optimal";
    } else {
      report.field = "parameters.max_states";
      report.message = text("the search gave up after ", route.expanded, " states");
      report.hint = "raise max_states";
    }
    return report;
  }
  const bool at_goal = !route.cut.empty() && std::all_of(route.cut.begin(), route.cut.end(), [&](State state) {
    return node_of(state) == node_of(route.cut.front());
  }) && node_of(route.cut.front()) == goal;
  report.error = at_goal ? PlanError::kUnreachableGoal : PlanError::kNoPath;
  report.field = "goal.base.position";
  report.message = route.penalised > 0
                       ? text("no stable route: the paper's search goes through ", route.penalised, " unstable stances")
                       : text("no route leads from the start to the goal: ", route.blocked);
  report.hint = options.route.stability
                    ? "move the goal, raise friction if the ground is rougher than that, or take a finer resolution"
                    : "move the goal, or take a finer resolution";
  report.figures.push_back({"states of the cut", static_cast<double>(route.cut.size()), 0.0, "1"});
  return report;
}

}  // namespace foothold::octopod
