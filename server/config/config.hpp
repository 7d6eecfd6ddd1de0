// What config/footholdd.yaml and config/robots/*.yaml say, as plain values. Paths are absolute after loading; times are seconds.
// Read by read_server_config() and read_robots() (reading.hpp), which also say what is allowed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "foothold/model.hpp"

namespace foothold::server {

// `dds:`
struct DdsConfig {
  std::string vendor = "cyclone";  // cyclone or fastdds
  std::uint32_t domain = 0;        // 0 to 200
  std::string network_config;      // a vendor's XML file; empty: loopback only
  std::string security;            // a folder of credentials; empty: DDS Security is off

  bool operator==(const DdsConfig&) const = default;
};

// `workers:` How workers that died are started again, and when a robot is taken out.
struct WorkersConfig {
  double restart_first = 0.1;          // wait before the first restart; doubled after each crash
  double restart_longest = 30.0;       // at most
  double start_limit = 60.0;           // a worker that is not ready by then is killed and counted as crashed
  std::size_t quarantine_crashes = 3;  // this many crashes
  double quarantine_window = 60.0;     // within this time
  double quarantine_time = 60.0;       // take the robot out for so long
};

// `scenes:`
struct ScenesConfig {
  std::uint64_t max_bytes = 64ull << 20;  // of one file
  std::vector<std::string> preload;       // folders whose files are stored at start, named by their stem
};

// `metrics:` Figures and health over HTTP.
struct MetricsConfig {
  bool enabled = true;
  std::string address = "127.0.0.1";  // IPv4 or IPv6, as numbers
  std::uint16_t port = 9747;          // 0: one that is free; the log says which

  bool operator==(const MetricsConfig&) const = default;
};

// `admission:` What one client may ask for at a time, beside `queue_limit`, which is for all.
struct AdmissionConfig {
  std::size_t queued_per_client = 250;  // requests that wait
  std::size_t running_per_client = 0;   // plans at the same time, of all robots; 0: as many as there are slots

  bool operator==(const AdmissionConfig&) const = default;
};

// `bundles:` What crashed and slow plans leave in the state folder.
struct BundlesConfig {
  double slow = 30.0;     // s of planning; 0: no plan is slow
  std::size_t keep = 20;  // of crashed plans, and as many of slow ones; 0: none is made
};

struct ServerConfig {
  std::string name = "foothold";
  DdsConfig dds;
  std::string state_dir;           // journal and scenes
  std::string plugin_dir;          // <plugin>.so
  std::string robots_dir;          // <robot>.yaml
  std::string worker;              // the worker program; empty: foothold-worker beside footholdd
  std::size_t queue_limit = 1000;  // requests that wait, of all robots
  double budget_max = 3600.0;
  double grace = 0.25;             // from the stop token to the kill
  double cancel_memory = 10.0;     // how long a cancel waits for its request
  double retention = 7 * 86400.0;  // of final states and steps
  AdmissionConfig admission;
  WorkersConfig workers;
  ScenesConfig scenes;
  MetricsConfig metrics;
  BundlesConfig bundles;
  std::string log_level = "info";  // trace, debug, info, warn, error, off
};

// One robot's file.
struct RobotConfig {
  std::string file;  // config/robots/<name>.yaml
  std::string name;  // `robot:`, what a request says
  std::string description;
  std::string plugin;              // absolute path of the shared library
  std::size_t slots = 1;           // workers, that is: plans at the same time
  std::uint64_t memory_limit = 0;  // bytes of address space of one worker; 0: none
  bool enabled = true;
  RobotModel model;  // `model:`, in SI
};

// All that the server is started with, or reloads.
struct Settings {
  ServerConfig server;
  std::vector<RobotConfig> robots;
};

}  // namespace foothold::server
