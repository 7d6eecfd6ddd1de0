// Costs, proofs and reasons.
#include "hyrecro/report.hpp"

#include <algorithm>
#include <utility>

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
  int face = found.route.start.face;
  for (const Stride& stride : found.route.strides)
    if (std::exchange(face, stride.to.face) != stride.to.face) ++transitions;
  const auto add = [&](const char* name, double value, double least, const char* unit) {
    report.figures.push_back({name, value, least, unit});
  };
  add("strides", static_cast<double>(found.route.strides.size()), 0.0, "1");
  add("transitions", transitions, 0.0, "1");
  add("length", length_of(truss, found.route), 0.0, "m");
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

}  // namespace foothold::hyrecro
