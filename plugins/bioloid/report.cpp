// Figures of walks.
#include "bioloid/report.hpp"

#include <sstream>

namespace foothold::bioloid {
namespace {

// Of the centre of mass over single supports, at the samples: the paper's 'error'.
struct Errors {
  double sum = 0.0, squares = 0.0;
  std::size_t count = 0;
  void add(double error) {
    sum += error;
    squares += error * error;
    ++count;
  }
  double mean() const { return count ? sum / static_cast<double>(count) : 0.0; }
  double variance() const { return count ? std::max(0.0, squares / static_cast<double>(count) - mean() * mean()) : 0.0; }
};

}  // namespace

PlanReport walked_report(const Model& model, const Walk& walk, const Stand& stand, const Options& options,
                         const PaperFigures& paper, double time) {
  PlanReport report;
  report.outcome = PlanReport::Outcome::kReached;
  report.cost = static_cast<double>(walk.steps.size());
  report.lower_bound = static_cast<double>(walk.least);
  report.optimal = walk.least == walk.steps.size();
  report.cost_unit = "placements";
  std::ostringstream objective;
  objective << "fewest placements of alternate feet on a lattice of " << 1e3 * options.walk.steps.cell << " mm and "
            << options.walk.steps.heading * 180.0 / M_PI << " deg, goal exact, every stride certified between its samples";
  report.objective = objective.str();
  Judge judge(model, options.gait.demands);
  Errors errors;
  double turned = 0.0, seconds = 0.0;
  for (const WalkStep& step : walk.steps)
    for (const Phase& phase : step.stride.phases) {
      turned += travel(phase.points);
      seconds += phase.times.back();
      if (phase.support.both) continue;
      for (const Joints& joints : phase.points) errors.add(judge.balance(joints, phase.support).error);
    }
  const auto add = [&](const char* name, double value, const char* unit) { report.figures.push_back({name, value, 0.0, unit}); };
  add("mean error on one foot", errors.mean(), "m");
  add("variance of the error", errors.variance(), "m^2");
  add("joint travel", turned, "rad");
  add("duration", seconds, "s");
  add("posture taken first", stand.midway ? 0.0 : 1.0, "1");
  add("footsteps expanded", static_cast<double>(walk.expanded), "1");
  add("routes tried", static_cast<double>(walk.routes), "1");
  add("search", time, "ms");
  if (!options.gait.paper) return report;
  add("trials", static_cast<double>(paper.trials), "1");
  add("trials that reached", static_cast<double>(paper.reached), "1");
  add("iterations", static_cast<double>(paper.iterations), "1");
  add("movements", static_cast<double>(paper.movements), "1");
  return report;
}

PlanReport failed_report(const Walk& walk, const Options& options) {
  PlanReport report;
  report.outcome = PlanReport::Outcome::kFailed;
  report.error = PlanError::kNoPath;
  report.field = "goal.base.position";
  std::ostringstream text;
  switch (walk.end) {
    case Walk::End::kTooMany:
      report.error = PlanError::kSearchLimit;
      text << "no walk was found among " << walk.expanded << " footsteps";
      report.hint = "give a nearer goal, or a coarser lattice (cell)";
      break;
    case Walk::End::kNoStrides:
      report.error = PlanError::kSearchLimit;
      if (options.gait.paper) {
        text << "no trial of the method asked for found a way for a lifted foot in " << options.gait.paper->method.iterations
             << " iterations (rows of footsteps tried: " << walk.routes << ")";
        report.field = "parameters.method";
        report.hint = "raise iterations or trials; method stochastic needs far fewer than random, optimal none";
        break;
      }
      text << "none of " << walk.routes << " rows of footsteps could be walked among the obstacles";
      report.hint = "give the robot more room, or lower clearance";
      break;
    default:
      text << "no row of footsteps leads to the goal (" << walk.expanded << " were looked at)";
      if (!walk.hindrance.empty()) text << "; most of all, " << walk.hindrance;
      report.hint = "move the goal, raise step_over (" + std::to_string(options.walk.step_over) + " m), or lower clearance";
  }
  report.message = text.str();
  return report;
}

}  // namespace foothold::bioloid
