// Contradictions first, then member by member.
#include "worker/report.hpp"

#include <cmath>
#include <sstream>

#include "foothold/msg/errors.hpp"
#include "text/text.hpp"
#include "worker/convert.hpp"

namespace foothold::server {
namespace {

// A bound and a cost that are summed up in different orders may differ in their last digits.
constexpr double kRounding = 1e-9;

std::string pair_of(const char* a, double x, const char* b, double y) {
  std::ostringstream out;
  out.precision(17);
  out << a << ' ' << x << " and " << b << ' ' << y;
  return out.str();
}

std::optional<std::string> costs_contradict(const PlanReport& report) {
  if (!std::isfinite(report.cost)) return "reports a cost that is not finite";
  if (!std::isfinite(report.lower_bound)) return "reports a lower bound that is not finite";
  const double slack = kRounding * (1.0 + std::abs(report.cost));
  using Outcome = PlanReport::Outcome;
  if (report.optimal && report.outcome != Outcome::kReached && report.outcome != Outcome::kPartial)
    return "claims to be optimal without a plan";
  if (report.optimal && std::abs(report.cost - report.lower_bound) > slack)
    return "claims to be optimal with " + pair_of("cost", report.cost, "lower bound", report.lower_bound);
  if (report.outcome == Outcome::kReached && report.lower_bound > report.cost + slack)
    return "reports a goal reached below what it proved: " + pair_of("cost", report.cost, "lower bound", report.lower_bound);
  for (const Margin& figure : report.figures) {
    if (!std::isfinite(figure.value) || !std::isfinite(figure.least))
      return "reports the figure " + quoted(figure.name) + ", which is not finite";
    if (!is_clean_text(figure.name) || !is_clean_text(figure.unit))
      return "reports a figure whose name or unit is no clean text: " + quoted(figure.name);
  }
  return std::nullopt;
}

bool has_error(const PlanReport& report) { return report.error != PlanError::kNone || report.own_error != 0; }

std::optional<std::string> error_contradicts(const PlanReport& report) {
  if (report.own_error != 0 && (report.own_error < msg::PLUGIN_FIRST || report.own_error > msg::PLUGIN_LAST))
    return "reports an error of its own numbered " + std::to_string(report.own_error) + ", allowed are 900 to 999";
  const auto code = static_cast<std::uint16_t>(report.error);
  if (code != 0 && (code < msg::NO_PATH || code > msg::SEARCH_LIMIT || code == msg::STEP_REFUSED))
    return "reports error number " + std::to_string(code) + ", which a planner does not have";
  return std::nullopt;
}

msg::Error error_of(const PlanReport& report) {
  const std::uint16_t code = report.own_error != 0 ? report.own_error : static_cast<std::uint16_t>(report.error);
  msg::Error error = msg::make_error(code, cleaned(report.message), cleaned(report.field));
  if (report.own_error != 0) {
    error.name(report.error_name.empty() ? "PLUGIN_" + std::to_string(code) : cleaned(report.error_name));
    error.stage("search");
  }
  if (!report.hint.empty()) error.hint(cleaned(report.hint));
  return error;
}

msg::State state_of(PlanReport::Outcome outcome) {
  switch (outcome) {
    case PlanReport::Outcome::kReached:
      return msg::SUCCEEDED;
    case PlanReport::Outcome::kPartial:
      return msg::PARTIAL;
    case PlanReport::Outcome::kStopped:
      return msg::CANCELLED;
    case PlanReport::Outcome::kFailed:
      break;
  }
  return msg::FAILED;
}

}  // namespace

std::optional<std::string> contradiction(const PlanReport& report, bool ended) {
  using Outcome = PlanReport::Outcome;
  if (report.outcome > Outcome::kStopped)
    return "reports outcome number " + std::to_string(static_cast<unsigned>(report.outcome)) + ", which there is not";
  if (auto fault = costs_contradict(report)) return fault;
  if (auto fault = error_contradicts(report)) return fault;
  if (report.outcome == Outcome::kReached && has_error(report)) return "reports the goal reached together with an error";
  if ((report.outcome == Outcome::kPartial || report.outcome == Outcome::kFailed) && !has_error(report))
    return "reports a plan that does not reach the goal without saying why";
  if (report.outcome == Outcome::kStopped && !ended) return "says that it was stopped, but nobody told it to";
  return std::nullopt;
}

frame::Report failed(msg::Error error) {
  frame::Report out;
  out.state(msg::FAILED);
  out.reason(std::move(error));
  return out;
}

frame::Report to_report(const PlanReport& report, bool ended) {
  if (const auto fault = contradiction(report, ended)) return failed(msg::make_error(msg::WORKER_PROTOCOL, "plan() " + *fault));
  frame::Report out;
  out.state(state_of(report.outcome));
  if (has_error(report)) out.reason(error_of(report));
  msg::Summary& summary = out.summary();
  summary.cost(report.cost);
  summary.lower_bound(report.lower_bound);
  summary.cost_unit(cleaned(report.cost_unit));
  summary.optimal(report.optimal);
  summary.objective(cleaned(report.objective));
  summary.figures(to_message(report.figures));
  return out;
}

}  // namespace foothold::server
