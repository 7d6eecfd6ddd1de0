// Costs, proofs and reasons.
#include "hexpiderix/report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace foothold::hexpiderix {
namespace {

constexpr double kNoFriction = 1000.0;  // told of stances that no friction holds: figures are finite

}  // namespace

PlanReport found_report(const Model& model, const Adaption& found, const Start& from, const Options& options, double time) {
  PlanReport report;
  report.outcome = PlanReport::Outcome::kReached;
  report.cost = -found.evaluation.nesm;
  report.cost_unit = "m";
  const double needed = std::min(kNoFriction, friction_needed(found.footholds, found.evaluation.centre_of_mass));
  report.lower_bound = report.cost;
  if (options.adapt.method == Method::kOptimal) {
    // The grid's best is proved; the posture sent is that one polished, so it is better still.
    report.optimal = found.proved;
    report.objective = found.proved ? "greatest stability (NESM) of all thorax poses of the grid, then polished between them"
                                    : "a stable posture (NESM above 0)";
  } else {
    report.objective = "a stable posture (NESM above 0) by the paper's strategies; nothing is made greatest";
  }
  if (!report.optimal) report.lower_bound = -1.0;
  const Evaluation before = stability_of(model, from.situation.footholds, from.at);
  const auto add = [&](const char* name, double value, double bound, const char* unit) {
    report.figures.push_back({name, value, bound, unit});
  };
  add("NESM", found.evaluation.nesm, 0.0, "m");
  if (options.adapt.method == Method::kOptimal) add("NESM of the grid's best", found.on_grid, 0.0, "m");
  add("NESM before", std::max(before.nesm, -1.0), 0.0, "m");
  add("projected margin", found.evaluation.margin, 0.0, "m");
  add("friction needed", needed, options.adapt.best.friction, "1");
  add("boxes of poses", static_cast<double>(found.boxes), 0.0, "1");
  add("postures judged", static_cast<double>(found.evaluated), 0.0, "1");
  add("search", time, 0.0, "ms");
  return report;
}

PlanReport failed_report(const Adaption& found) {
  PlanReport report;
  report.outcome = PlanReport::Outcome::kFailed;
  report.message = found.because;
  switch (found.end) {
    case Adaption::End::kExhausted:
      report.error = PlanError::kSearchLimit;
      report.field = "parameters.max_boxes";
      report.hint = "raise max_boxes, or take a coarser grid";
      break;
    case Adaption::End::kRefused:
      report.error = PlanError::kCollision;
      report.field = "parameters.method";
      report.hint = "take method optimal or choice";
      break;
    default:
      report.error = PlanError::kUnstable;
      report.field = "start.base";
      report.hint = "allow further legs (legs: add or any), or take method optimal";
  }
  return report;
}

PlanReport walked_report(const Model& model, const Walk& found, const Stand& from, const Station& goal, const Options& options,
                         double time) {
  PlanReport report;
  report.outcome = PlanReport::Outcome::kReached;
  report.cost_unit = "m";
  report.objective = "a walk by alternating tripods whose stability (NESM) keeps its bound; its length is the thorax' way";
  double least = std::numeric_limits<double>::infinity(), friction = 0.0;
  const Stand* at = &from;
  for (const HalfCycle& half : found.half_cycles) {
    report.cost += (half.to.at.thorax.translation() - at->at.thorax.translation()).norm();
    least = std::min(least, half.least_nesm);
    Footholds held = at->feet;
    held.supports &= ~half.swinging;
    for (const Coordinates* end : {&half.way.front(), &half.way.back()})
      friction = std::max(friction, std::min(kNoFriction, friction_needed(held, end->thorax * centre_of_mass(model, end->legs))));
    at = &half.to;
  }
  report.lower_bound = (at->at.thorax.translation() - from.at.thorax.translation()).norm();
  report.lower_bound = std::min(report.lower_bound, report.cost);
  const auto add = [&](const char* name, double value, double bound, const char* unit) {
    report.figures.push_back({name, value, bound, unit});
  };
  add("least NESM", least, options.walk.least_nesm, "m");
  add("friction needed", friction, options.adapt.best.friction, "1");
  add("distance to goal", (at->at.thorax.translation() - goal.place).head<2>().norm(), 0.0, "m");
  add("half cycles", static_cast<double>(found.half_cycles.size()), 0.0, "1");
  add("half cycles tried", static_cast<double>(found.tried), 0.0, "1");
  add("search", time, 0.0, "ms");
  return report;
}

PlanReport blocked_report(const Walk& found) {
  PlanReport report;
  report.outcome = PlanReport::Outcome::kFailed;
  report.error = PlanError::kNoPath;
  report.field = "goal.base.position";
  std::ostringstream text;
  text << "no walk was found: the farthest try ended at (" << found.farthest.x() << ", " << found.farthest.y() << ", "
       << found.farthest.z() << ") m after " << found.tried << " half cycles; there " << found.because;
  report.message = text.str();
  report.hint = "move the goal, lower least_nesm, or take a shorter stride";
  return report;
}

}  // namespace foothold::hexpiderix
