// foothold replay: asks once more for the plan of a file, a bundle or the journal, under a new id, with its seed, scene revision
// and parameters, and compares octet for octet.
#include <algorithm>

#include "connection.hpp"
#include "follow.hpp"
#include "foothold/client/plan_file.hpp"
#include "foothold/msg/cdr.hpp"
#include "foothold/msg/errors.hpp"
#include "past.hpp"
#include "report.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

constexpr double kGrace = 5.0;

// The number of the first step that is not the same, ids aside; nothing if all are.
std::optional<std::size_t> first_difference(const std::vector<msg::Step>& before, const std::vector<msg::Step>& now) {
  const std::size_t common = std::min(before.size(), now.size());
  for (std::size_t i = 0; i < common; ++i) {
    msg::Step step = now[i];
    step.request(before[i].request());
    step.server(before[i].server());
    if (msg::encode(step) != msg::encode(before[i])) return i;
  }
  return before.size() == now.size() ? std::nullopt : std::optional(common);
}

std::string parameters(const msg::Summary& summary) {
  std::string text;
  for (const msg::Parameter& p : summary.parameters()) text += (text.empty() ? "" : " ") + p.name() + "=" + p.value();
  return text;
}

// What could make a difference, then and now.
std::vector<std::vector<std::string>> differences(const msg::Summary& before, const msg::Summary& now) {
  std::vector<std::vector<std::string>> rows;
  const auto compare = [&](const char* what, const std::string& a, const std::string& b) {
    if (a != b) rows.push_back({what, printable(a), "now", printable(b)});
  };
  compare("planner", before.plugin() + " " + before.plugin_version(), now.plugin() + " " + now.plugin_version());
  compare("server", before.server_version(), now.server_version());
  compare("scene", before.scene_revision(), now.scene_revision());
  compare("seed", std::to_string(before.seed()), std::to_string(now.seed()));
  compare("parameters", parameters(before), parameters(now));
  return rows;
}

// A request that is refused has no summary: then what the server announces is what is different now.
msg::Summary present(const msg::Summary& before, const msg::PlanEvent& end, const Connection& connection) {
  if (!end.summary().plugin().empty()) return end.summary();
  msg::Summary now = before;
  now.server_version(connection.server.info.version());
  if (const auto robot = connection.client->wait_for_robot(before.robot(), 0.0, connection.wanted)) {
    now.plugin(robot->plugin());
    now.plugin_version(robot->plugin_version());
  }
  return now;
}

}  // namespace

Exit run_replay(const Common& common, const ReplayOptions& options) {
  const PastPlan past = past_plan(options.source, options.state_dir);
  const client::PlanRecord& before = past.plan;
  const msg::Summary& summary = before.final_event.summary();
  if (before.request.robot().empty() || summary.plugin().empty())
    throw Complaint(Exit::kUsage, past.origin + ": holds no request and summary to plan again",
                    "only what has run and ended can be compared; 'foothold plan ... -o FILE' writes a file that holds it");
  const Connection connection = connect(common);
  msg::PlanRequest request = before.request;
  request.id(msg::random_id());
  request.server(connection.wanted);
  request.scene_revision(summary.scene_revision());
  request.seed(summary.seed());
  request.parameters(summary.parameters());
  client::Plan plan = connection.client->submit(request);
  const msg::PlanEvent end =
      follow(plan, common, {.verbose = false, .show_steps = false, .patience = request.budget() + common.timeout + kGrace});
  const client::PlanRecord now = plan.record();
  if (!options.output.empty()) client::write_plan_file(options.output, now);
  if (common.json)
    std::puts(client::to_json_line(end).c_str());
  else
    print_end(end);
  const auto different = first_difference(before.steps, now.steps);
  if (!different && end.state() == before.final_event.state()) {
    if (!common.json) std::printf("the same plan: %zu steps, equal octet for octet\n", now.steps.size());
    return exit_of(end.state());
  }
  const auto rows = differences(summary, present(summary, end, connection));
  if (!common.json && !rows.empty()) print_table(rows, "  ");
  std::string message = "another plan: it ended " + std::string(msg::state_name(end.state())) + ", before " +
                        std::string(msg::state_name(before.final_event.state()));
  if (different)
    message = "another plan: step " + std::to_string(*different) + " is the first that differs; " +
              std::to_string(now.steps.size()) + " steps, before " + std::to_string(before.steps.size());
  throw Complaint(
      Exit::kDiffers, message,
      rows.empty() ? "planner, server, scene, seed and parameters are the same: its planner is not repeatable, or ran out of budget"
                   : "what differs is listed above");
}

}  // namespace foothold::cli
