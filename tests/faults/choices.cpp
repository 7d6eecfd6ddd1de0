// See choices.hpp.
#include "choices.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include "foothold/client/request_file.hpp"
#include "wire.hpp"

namespace foothold::faults {
namespace fs = std::filesystem;

namespace {

constexpr double kLongest = 2.0;     // s
constexpr double kShortest = 0.005;  // s: what a request costs beside its plan

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<test::TestRobot> shipped_robots() {
  std::vector<test::TestRobot> robots;
  for (const fs::path& file : files_of(FOOTHOLD_CONFIG_DIR "/robots")) {
    const std::string name = file.stem().string();
    if (fs::exists(fs::path(FOOTHOLD_PLUGINS) / (name + ".so"))) robots.push_back({.name = name, .file = file.string()});
  }
  return robots;
}

std::vector<std::string> write_choices(const test::DaemonOptions& server, const std::string& file) {
  test::Daemon daemon(server);
  test::Wire wire(server.vendor, server.domain);
  std::set<std::string> missing;
  for (const test::TestRobot& robot : server.robots) {
    if (!wire.connect(robot.name, 60.0)) throw std::runtime_error(robot.name + " does not become ready");
    missing.insert(robot.name);
  }
  std::vector<std::string> left_out;
  std::ofstream out(file);
  for (const fs::path& path : files_of(FOOTHOLD_CONFIG_DIR "/requests")) {
    msg::PlanRequest request = client::read_request_file(path.string()).request;
    if (std::ranges::none_of(server.robots, [&](const auto& robot) { return robot.name == request.robot(); })) continue;
    request.budget(kLongest);
    request.shapes(false);
    // The second time the scene is prepared, as it is mostly in the storm.
    wire.submit(request);
    const auto end = wire.final_event(wire.submit(request), 20.0);
    const double planned = end ? end->message.summary().planned() : kLongest;
    if (end && end->message.state() == msg::SUCCEEDED) {
      out << 1.0 / std::max(planned, kShortest) << ' ' << path.string() << '\n';
      missing.erase(request.robot());
    } else {
      left_out.push_back(path.stem().string() + ": " + (end ? test::describe(end->message) : "no end"));
    }
  }
  if (!missing.empty()) throw std::runtime_error("no request of " + *missing.begin() + " is planned in time for a storm");
  return left_out;
}

}  // namespace foothold::faults
