// The real footholdd in a test: its own configuration, state directory and domain, stopped and cleaned up whatever happens.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "child.hpp"
#include "temporary_folder.hpp"

namespace foothold::test {

// A robot of the server: its file is written from these.
struct TestRobot {
  std::string name;
  std::string plugin;  // as in the build's folder of plugins
  unsigned slots = 1;
  std::string memory_limit;  // as in the robot's file; empty: none
  std::string file;          // a robot's file to be copied instead; empty: none
};

struct DaemonOptions {
  std::string name = "test";
  std::string vendor = "cyclone";
  std::uint32_t domain = 0;
  std::vector<TestRobot> robots;
  double grace = 0.25;  // s
  std::string log_level = "info";
  std::string more;        // further lines of the configuration
  std::string plugin_dir;  // empty: that of the test planners
  std::string security;    // folder of credentials; empty: none
  std::string state_dir;   // empty: one of its own
};

// Thread rule: the main thread.
class Daemon {
 public:
  // Starts it; throws std::runtime_error if that fails. It is ready when its robots are announced: ask the bus.
  explicit Daemon(DaemonOptions options);
  ~Daemon();  // shows the log if the test has failed
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  pid_t pid() const { return child_->pid(); }
  bool running() { return child_->running(); }
  // Its workers that are alive, in the order of their pids.
  std::vector<pid_t> workers() const;
  // SIGTERM. The exit code, or minus the signal that ended it; nothing if it does not end within `seconds` (it is killed then).
  std::optional<int> stop(double seconds = 5.0);
  void kill();  // SIGKILL to the daemon alone, as a crash would
  // Other options from the next start on, or from the next SIGHUP: the files are written anew. The domain stays.
  void configure(DaemonOptions options);
  void hang_up();  // SIGHUP
  void signal(int number) { child_->signal(number); }
  void start();  // again, on the same state directory, after stop() or kill()

  std::string log() const;  // of all starts
  std::string state_folder() const { return directory_ / "state"; }
  const DaemonOptions& options() const { return options_; }

 private:
  void write_configuration() const;

  DaemonOptions options_;
  TemporaryFolder directory_;
  std::unique_ptr<Child> child_;
};

}  // namespace foothold::test
