// Workers with real foothold-worker processes on a loop of the test's own, with a recorder in the place of Jobs.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "workers/workers.hpp"

namespace foothold::server::test {

// What was told of one run.
struct Heard {
  msg::PlanRequest request;
  std::vector<msg::Step> steps;
  std::optional<std::vector<msg::Shape>> scene;
  std::vector<RunEnd> ends;
  Time started{}, ended{};
};

class Rig : private RunEvents {
 public:
  // A robot that is served by tests/plugins/<plugin>.cpp. Its name is the plugin's unless another is given.
  static RobotConfig robot(const std::string& plugin, std::size_t slots = 1, std::string name = {});
  static msg::PlanRequest request(const std::string& robot, std::vector<std::pair<std::string, std::string>> parameters = {});

  // Opens and runs the loop until every robot is settled.
  void open(std::vector<RobotConfig> robots);
  void open(std::vector<RobotConfig> robots, const WorkersConfig& limits);
  Run start(const msg::PlanRequest& request, const std::optional<StoredScene>& scene = {});
  // Starts and runs the loop until it ended.
  const Heard& plan(const msg::PlanRequest& request);
  // Runs the loop until `condition` holds; throws after `limit`.
  void run_until(const std::function<bool()>& condition, std::chrono::milliseconds limit = std::chrono::seconds(20));
  void run_for(std::chrono::milliseconds time);
  const Heard& end_of(Run run);

  boost::asio::io_context loop;
  std::unique_ptr<Workers> workers;
  std::map<Run, Heard> heard;
  std::string program = FOOTHOLD_WORKER;
  int settled = 0, slot_changes = 0;

 private:
  void on_run_scene(Run run, std::vector<msg::Shape> shapes) override;
  void on_run_step(Run run, std::uint32_t index, Bytes step) override;
  void on_run_end(Run run, RunEnd end) override;
  void on_slots_changed(const std::string& robot) override;

  bool inside_call_ = false;
};

}  // namespace foothold::server::test
