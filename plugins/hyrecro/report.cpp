// Costs, proofs and reasons.
#include "hyrecro/report.hpp"

#include <algorithm>

#include "hyrecro/steps.hpp"

namespace foothold::hyrecro {

PlanReport report_of(const Found& found, const Options& options, const truss::Truss& truss, const PlanTimes& times) {
  PlanReport report;
  report.outcome = PlanReport::Outcome::kReached;
  report.cost = found.cost;
  report.lower_bound = std::min(found.lower_bound, found.cost);
  report.optimal = found.optimal && report.cost - report.lower_bound <= 1e-9 * std::max(1.0, report.cost);
  report.cost_unit = options.optimal.objective == Objective::kDistance ? "m" : "steps";
  report.objective = found.objective;

  int transitions = 0;
  double length = 0.0;
  Foothold before = found.route.start;
  for (const Stride& stride : found.route.strides) {
    if (stride.to.face != before.face) ++transitions;
    length += (pose_of(truss, stride.to).translation() - pose_of(truss, before).translation()).norm();
    before = stride.to;
  }
  const auto add = [&](const char* name, double value, double least, const char* unit) {
    report.figures.push_back({name, value, least, unit});
  };
  add("strides", static_cast<double>(found.route.strides.size()), 0.0, "1");
  add("transitions", transitions, 0.0, "1");
  add("length", length, 0.0, "m");
  report.figures.insert(report.figures.end(), found.figures.begin(), found.figures.end());
  add("search", times.search, 0.0, "ms");
  if (options.motion) add("motion", times.motion, 0.0, "ms");
  return report;
}

PlanReport failed_report(const Failure& failure) {
  PlanReport report;
  report.outcome = PlanReport::Outcome::kFailed;
  report.error = failure.error == PlanError::kNone ? PlanError::kNoPath : failure.error;
  report.field = failure.field;
  report.message = failure.message;
  report.hint = failure.hint;
  return report;
}

PlanReport stopped_report() {
  PlanReport report;
  report.outcome = PlanReport::Outcome::kStopped;
  report.message = "stopped before the end of the search";
  return report;
}

}  // namespace foothold::hyrecro
