// foothold robots: what the servers plan for.
#include <algorithm>

#include "connection.hpp"
#include "foothold/client/plan_file.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

constexpr double kQuiet = 0.3;  // s without an announcement after which the list counts as whole

std::string state_of(const msg::RobotInfo& robot) {
  if (robot.state() == msg::READY) return coloured(Colour::kGood, "ready");
  if (robot.state() == msg::QUARANTINED) return coloured(Colour::kBad, "quarantined");
  return coloured(Colour::kBad, "unavailable");
}

std::string range_of(const msg::ParameterSpec& spec) {
  const std::string unit = spec.unit().empty() || spec.unit() == "1" ? "" : " " + printable(spec.unit());
  switch (spec.kind()) {
    case msg::FLAG:
      return "true or false";
    case msg::INTEGER:
    case msg::REAL:
      return number(spec.minimum()) + " to " + number(spec.maximum()) + unit;
    case msg::TEXT:
      return "text";
    case msg::CHOICE:
      break;
  }
  std::string choices;
  for (const std::string& choice : spec.choices()) choices += (choices.empty() ? "" : " | ") + printable(choice);
  return choices;
}

void print_details(const msg::RobotInfo& robot) {
  std::printf("\n%s\n", coloured(Colour::kBold, printable(robot.name())).c_str());
  if (!robot.start_needs().empty()) std::printf("  start: %s\n", printable(robot.start_needs()).c_str());
  if (!robot.goal_needs().empty()) std::printf("  goal:  %s\n", printable(robot.goal_needs()).c_str());
  std::vector<std::vector<std::string>> rows = {{"PARAMETER", "DEFAULT", "RANGE", "WHAT IT IS"}};
  for (const msg::ParameterSpec& spec : robot.parameters())
    rows.push_back({printable(spec.name()), printable(spec.default_value()), range_of(spec), printable(spec.description())});
  print_table(rows, "  ");
}

}  // namespace

Exit run_robots(const Common& common, const RobotsOptions& options) {
  const Connection connection = connect(common);
  // A server announces its robots when their planners are loaded, which takes a moment after its start.
  if (!options.robot.empty()) connection.client->wait_for_robot(options.robot, common.timeout, connection.wanted);
  for (double waited = 0.0; connection.client->robots().empty() && waited < common.timeout; waited += kQuiet)
    connection.client->wait_for_lists(kQuiet, kQuiet);
  connection.client->wait_for_lists(common.timeout, kQuiet);

  std::vector<msg::RobotInfo> robots = connection.client->robots();
  std::erase_if(robots, [&](const msg::RobotInfo& robot) {
    return (!options.robot.empty() && robot.name() != options.robot) ||
           (connection.wanted != msg::kNoId && robot.server() != connection.wanted);
  });
  if (robots.empty() && !options.robot.empty())
    throw Complaint(Exit::kOther, "no server has a robot '" + printable(options.robot) + "'",
                    "'foothold robots' lists what there is");
  if (common.json) {
    for (const msg::RobotInfo& robot : robots) std::puts(client::to_json_line(robot).c_str());
    return Exit::kSucceeded;
  }
  std::printf("%s\n", describe(connection, common).c_str());
  if (robots.empty()) throw Complaint(Exit::kOther, "it has announced no robot", "its log says which planners could not be loaded");
  std::vector<std::vector<std::string>> rows = {{"ROBOT", "STATE", "SLOTS", "PLANNER", "WHAT IT IS"}};
  for (const msg::RobotInfo& robot : robots)
    rows.push_back({printable(robot.name()), state_of(robot), std::to_string(robot.slots()),
                    printable(robot.plugin()) + " " + printable(robot.plugin_version()),
                    printable(robot.state() == msg::READY ? robot.description() : robot.reason())});
  print_table(rows);
  if (options.parameters || !options.robot.empty())
    for (const msg::RobotInfo& robot : robots) print_details(robot);
  return Exit::kSucceeded;
}

}  // namespace foothold::cli
