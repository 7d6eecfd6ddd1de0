// foothold plan: from a request file to footholds.
#include <algorithm>

#include "connection.hpp"
#include "follow.hpp"
#include "foothold/client/plan_file.hpp"
#include "foothold/client/request_file.hpp"
#include "foothold/msg/errors.hpp"
#include "report.hpp"
#include "scene.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

constexpr double kGrace = 5.0;  // s beyond budget and timeout that a plan is waited for

void set_parameter(msg::PlanRequest& request, const std::string& setting) {
  const auto equals = setting.find('=');
  if (equals == std::string::npos || equals == 0)
    throw Complaint(Exit::kUsage, "--set " + setting + ": expected key=value", "'foothold robots --parameters' lists the keys");
  const std::string name = setting.substr(0, equals);
  auto& parameters = request.parameters();
  auto parameter = std::ranges::find_if(parameters, [&](const msg::Parameter& p) { return p.name() == name; });
  if (parameter == parameters.end()) parameter = parameters.emplace(parameters.end());
  parameter->name(name);
  parameter->value(setting.substr(equals + 1));
}

client::RequestFile read(const PlanOptions& options) {
  client::RequestFile file;
  try {
    file = client::read_request_file(options.file);
  } catch (const client::RequestFileError& error) {
    throw Complaint(Exit::kUsage, error.what());
  }
  msg::PlanRequest& request = file.request;
  for (const std::string& setting : options.set) set_parameter(request, setting);
  if (options.budget) request.budget(*options.budget);
  if (options.seed) request.seed(*options.seed);
  if (options.priority) request.priority(*options.priority);
  if (options.shapes) request.shapes(true);
  if (!options.robot.empty()) request.robot(options.robot);
  if (!options.scene.empty()) {
    const auto at = options.scene.find('@');
    request.scene(options.scene.substr(0, at));
    request.scene_revision(at == std::string::npos ? "" : options.scene.substr(at + 1));
    file.scene_file.clear();
  }
  if (request.budget() <= 0.0)
    throw Complaint(Exit::kUsage, options.file + ": budget: is missing", "give seconds there, or --budget");
  return file;
}

// The command that gives this plan again: every parameter, the seed and the scene's revision are written out.
std::string again(const PlanOptions& options, const msg::PlanRequest& request, const msg::Summary& summary) {
  std::string command = "foothold plan " + quoted(options.file);
  if (!options.robot.empty()) command += " --robot " + quoted(options.robot);
  if (!summary.scene_revision().empty()) command += " --scene " + quoted(summary.scene() + "@" + summary.scene_revision());
  command += " --budget " + number(request.budget()) + " --seed " + std::to_string(summary.seed());
  for (const msg::Parameter& parameter : summary.parameters())
    command += " --set " + quoted(parameter.name() + "=" + parameter.value());
  return command;
}

void upload(const Connection& connection, const Common& common, client::RequestFile& file) {
  const msg::SceneStatus verdict = put_scene(connection, common, file.scene_file, file.request.scene());
  if (verdict.state() != msg::STORED) {
    print(verdict.error(), stderr);
    throw Complaint(Exit::kRejected, file.scene_file + ": the server refused this scene");
  }
  file.request.scene_revision(verdict.revision());
  if (!common.json) std::printf("scene %s stored, revision %s\n", file.request.scene().c_str(), verdict.revision().c_str());
}

}  // namespace

Exit run_plan(const Common& common, const PlanOptions& options) {
  client::RequestFile file = read(options);
  const Connection connection = connect(common);
  if (!file.scene_file.empty()) upload(connection, common, file);
  file.request.id(msg::random_id());
  file.request.server(connection.wanted);
  if (!common.json)
    std::printf("request %s for %s to %s\n", msg::to_hex(file.request.id()).c_str(), printable(file.request.robot()).c_str(),
                describe(connection, common).c_str());
  std::fflush(stdout);

  client::Plan plan = connection.client->submit(file.request);
  const msg::PlanEvent end = follow(plan, common, {options.verbose, true, file.request.budget() + common.timeout + kGrace});
  if (!options.output.empty()) client::write_plan_file(options.output, plan.record());
  if (common.json) {
    std::puts(client::to_json_line(end).c_str());
    return exit_of(end.state());
  }
  print_end(end, end.summary().plugin().empty() ? "" : again(options, file.request, end.summary()));
  if (!options.output.empty()) std::printf("written to %s\n", options.output.c_str());
  return exit_of(end.state());
}

}  // namespace foothold::cli
