// Costs and proofs in words.
#include "report.hpp"

#include <sstream>

namespace foothold::xrobin {
namespace {

template <class... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream out;
  (out << ... << parts);
  return out.str();
}

void name_the_shortfall(PlanReport& report, const Limits& limits, const Solution& solution, double goal_distance, double reach) {
  report.outcome = PlanReport::Outcome::kPartial;
  if (solution.no_room) {
    report.error = PlanError::kCollision;
    report.field = "goal.base.position";
    report.message = text("obstacles leave the robot no room to stand within ", limits.tolerance, " m of the goal; the plan ends ",
                          solution.distance, " m away from it");
    report.hint = "move the goal, or lower clearance";
    return;
  }
  if (solution.no_way) {
    report.error = PlanError::kNoPath;
    report.field = "goal.base.position";
    report.message =
        text("obstacles part the start from the goal, or hold the goal; the plan ends ", solution.distance, " m away from it");
    report.hint = "move the goal";
    return;
  }
  if (goal_distance > reach + limits.tolerance) {
    report.error = PlanError::kUnreachableGoal;
    report.field = "goal.base.position";
    report.message = text("the goal is ", goal_distance, " m away, ", limits.max_cycles, " cycles advance ", reach, " m at most");
    report.hint = "raise max_cycles";
    return;
  }
  report.error = PlanError::kToleranceNotMet;
  report.field = "parameters.tolerance";
  report.message = text("the plan ends ", solution.distance, " m away from the goal, ", limits.tolerance, " m are allowed");
  report.hint = "raise tolerance, cycles or max_cycles, or take method optimal";
}

}  // namespace

PlanReport report_of(Method method, const Target& goal, const Limits& limits, const Mechanism& mechanism,
                     const Solution& solution) {
  PlanReport report;
  if (!solution.possible) {
    report.outcome = PlanReport::Outcome::kFailed;
    report.error = PlanError::kUnreachableGoal;
    report.field = "goal.base.orientation";
    report.message =
        text("no word of at most ", limits.cycles, " cycles ends within ", goal.heading_tolerance, " rad of the heading ",
             *goal.heading, " rad from the start's: headings are multiples of ", mechanism.eighth_turn(), " rad nearly");
    report.hint = "set any_orientation, or ask for a heading that is a multiple of 45 deg from the start's";
    return report;
  }
  const auto cycles = static_cast<int>(solution.word.size() / 2);
  const bool reached = solution.distance <= limits.tolerance;
  const std::string heading = goal.heading ? " in the wanted heading" : "";
  if (method == Method::kFewest) {
    report.cost = cycles;
    report.lower_bound = std::min(cycles, solution.least_cycles);
    report.optimal = reached && cycles <= solution.least_cycles;
    report.cost_unit = "cycles";
    report.objective = text("fewest cycles that end within ", limits.tolerance, " m of the goal", heading);
  } else {
    report.cost = solution.distance;
    report.lower_bound = std::min(solution.distance, solution.least_distance);
    report.optimal = solution.proved_cycles > 0 && cycles <= solution.proved_cycles &&
                     solution.distance - solution.least_distance <= 1e-9 && method != Method::kGreedy;
    report.cost_unit = "m";
    report.objective = text("least distance of body A to the goal", heading, " after at most ", solution.proved_cycles, " cycles");
  }
  report.figures = {{"distance_to_goal", solution.distance, solution.least_distance, "m"},
                    {"cycles", static_cast<double>(cycles), static_cast<double>(std::min(cycles, solution.least_cycles)), "1"}};
  report.outcome = PlanReport::Outcome::kReached;
  if (!reached)
    name_the_shortfall(report, limits, solution, std::hypot(goal.x, goal.y), limits.max_cycles * mechanism.longest_cycle());
  return report;
}

}  // namespace foothold::xrobin
