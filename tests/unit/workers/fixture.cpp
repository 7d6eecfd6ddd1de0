// The recorder, which also holds Workers to its promises: nothing is told from inside a call, nothing after the end.
#include "fixture.hpp"

#include <stdexcept>

namespace foothold::server::test {

RobotConfig Rig::robot(const std::string& plugin, std::size_t slots, std::string name) {
  RobotConfig config;
  config.name = name.empty() ? plugin : std::move(name);
  config.plugin = std::string(FOOTHOLD_TEST_PLUGINS) + "/" + plugin + ".so";
  config.slots = slots;
  return config;
}

msg::PlanRequest Rig::request(const std::string& robot, std::vector<std::pair<std::string, std::string>> parameters) {
  msg::PlanRequest request;
  request.id(msg::random_id());
  request.client(msg::random_id());
  request.robot(robot);
  request.budget(10.0);
  request.seed(1);
  for (const auto& [name, value] : parameters) {
    msg::Parameter& parameter = request.parameters().emplace_back();
    parameter.name(name);
    parameter.value(value);
  }
  return request;
}

void Rig::open(std::vector<RobotConfig> robots) { open(std::move(robots), WorkersConfig{}); }

void Rig::open(std::vector<RobotConfig> robots, const WorkersConfig& limits) {
  workers = std::make_unique<Workers>(loop, WorkersOptions{program, limits}, std::move(robots));
  inside_call_ = true;
  workers->open(*this, [this] { ++settled; });
  inside_call_ = false;
  run_until([this] { return settled > 0; });
}

Run Rig::start(const msg::PlanRequest& request, const std::optional<StoredScene>& scene) {
  inside_call_ = true;
  const Run run = workers->start(request, request.budget(), scene);
  inside_call_ = false;
  heard[run].request = request;
  heard[run].started = std::chrono::steady_clock::now();
  return run;
}

const Heard& Rig::plan(const msg::PlanRequest& request) { return end_of(start(request)); }

const Heard& Rig::end_of(Run run) {
  run_until([&] { return !heard[run].ends.empty(); });
  return heard[run];
}

void Rig::run_until(const std::function<bool()>& condition, std::chrono::milliseconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!condition()) {
    if (std::chrono::steady_clock::now() >= end) throw std::runtime_error("what was waited for did not happen");
    loop.restart();
    loop.run_one_for(std::chrono::milliseconds(50));
  }
}

void Rig::run_for(std::chrono::milliseconds time) {
  loop.restart();
  loop.run_for(time);
}

void Rig::on_run_scene(Run run, std::vector<msg::Shape> shapes) {
  EXPECT_FALSE(inside_call_);
  EXPECT_TRUE(heard[run].ends.empty()) << "a scene after the end";
  heard[run].scene = std::move(shapes);
}

void Rig::on_run_step(Run run, std::uint32_t index, Bytes step) {
  EXPECT_FALSE(inside_call_);
  EXPECT_TRUE(heard[run].ends.empty()) << "a step after the end";
  const auto decoded = msg::decode<msg::Step>(step);
  ASSERT_TRUE(decoded.has_value());
  EXPECT_EQ(decoded->index(), index);
  EXPECT_EQ(decoded->request(), heard[run].request.id());
  EXPECT_EQ(index, heard[run].steps.size());
  heard[run].steps.push_back(*decoded);
}

void Rig::on_run_end(Run run, RunEnd end) {
  EXPECT_FALSE(inside_call_);
  EXPECT_TRUE(heard[run].ends.empty()) << "a second end";
  heard[run].ends.push_back(std::move(end));
  heard[run].ended = std::chrono::steady_clock::now();
}

void Rig::on_slots_changed(const std::string&) {
  EXPECT_FALSE(inside_call_);
  ++slot_changes;
}

}  // namespace foothold::server::test
