// See daemon.hpp.
#include "daemon.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace foothold::test {
namespace fs = std::filesystem;

namespace {

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

Daemon::Daemon(DaemonOptions options) : options_(std::move(options)) {
  write_configuration();
  start();
}

Daemon::~Daemon() {
  child_.reset();
  if (std::uncaught_exceptions() > 0 || testing::Test::HasFailure()) std::cerr << "---- log of footholdd\n" << log() << "----\n";
}

void Daemon::configure(DaemonOptions options) {
  options_ = std::move(options);
  write_configuration();
}

void Daemon::hang_up() { child_->signal(SIGHUP); }

void Daemon::write_configuration() const {
  fs::remove_all(directory_ / "robots");
  fs::create_directories(directory_ / "robots");
  std::ofstream file(directory_ / "footholdd.yaml");
  file << "name: " << options_.name << "\n"
       << "state_dir: " << (options_.state_dir.empty() ? directory_ / "state" : options_.state_dir) << "\n"
       << "robots_dir: " << directory_ / "robots"
       << "\n"
       << "plugin_dir: " << (options_.plugin_dir.empty() ? FOOTHOLD_TEST_PLUGINS : options_.plugin_dir) << "\n"
       << "worker: " << FOOTHOLD_WORKER << "\n"
       << "grace: " << options_.grace << "\n"
       << "log_level: " << options_.log_level << "\n"
       << "dds:\n  vendor: " << options_.vendor << "\n  domain: " << options_.domain << "\n"
       << (options_.security.empty() ? "" : "  security: " + options_.security + "\n") << options_.more;
  for (const TestRobot& robot : options_.robots) {
    const fs::path path = directory_ / ("robots/" + robot.name + ".yaml");
    if (!robot.file.empty()) {
      fs::copy_file(robot.file, path);
      continue;
    }
    std::ofstream out(path);
    out << "robot: " << robot.name << "\nplugin: " << robot.plugin << "\nslots: " << robot.slots << "\n";
    if (!robot.memory_limit.empty()) out << "memory_limit: " << robot.memory_limit << "\n";
  }
}

void Daemon::start() {
  child_ = std::make_unique<Child>(std::vector<std::string>{FOOTHOLD_DAEMON, "--config", directory_ / "footholdd.yaml"},
                                   directory_ / "log");
}

std::optional<int> Daemon::stop(double seconds) {
  child_->signal(SIGTERM);
  const std::optional<int> code = child_->wait(seconds);
  if (!code) kill();
  return code;
}

void Daemon::kill() {
  child_->signal(SIGKILL);
  child_->wait(5.0);
}

std::vector<pid_t> Daemon::workers() const {
  std::vector<pid_t> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    // "pid (name) state parent ...": the kernel cuts names to 15 octets, which is what this one has.
    std::istringstream stat(read_file(entry.path() / "stat"));
    std::string pid, command, state;
    pid_t parent = 0;
    stat >> pid >> command >> state >> parent;
    if (parent == child_->pid() && command == "(foothold-worker)" && state != "Z") found.push_back(std::stoi(pid));
  }
  std::ranges::sort(found);
  return found;
}

std::string Daemon::log() const { return read_file(directory_ / "log"); }

}  // namespace foothold::test
