// The commands of `foothold`: what each takes, and how it is run. Each has a source file of its own name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exit_code.hpp"

namespace foothold::cli {

// What every command takes.
struct Common {
  std::string dds = "cyclone";
  std::uint32_t domain = 0;
  std::string network;   // a vendor's configuration file; empty: loopback
  std::string security;  // a folder of credentials; empty: DDS Security is off
  std::string server;    // name or id; empty: any
  double timeout = 5.0;  // s to wait for a server or its answer
  bool json = false;
};

struct RobotsOptions {
  std::string robot;  // empty: all
  bool parameters = false;
};

struct PlanOptions {
  std::string file;
  std::vector<std::string> set;  // key=value
  std::optional<double> budget;
  std::optional<std::uint64_t> seed;
  std::optional<std::int32_t> priority;
  std::string robot, scene;  // scene: NAME or NAME@REVISION
  bool shapes = false, verbose = false;
  std::string output;
};

struct ReplayOptions {
  std::string source;  // a plan file, a bundle's folder, or a request's id
  std::string state_dir, output;
};

struct HistoryOptions {
  std::string id;  // empty: a list
  std::string state_dir;
  std::string robot, unit, state, client;  // empty: any
  double since = 0.0;                      // s back; 0: all
  std::size_t most = 20;
  std::string output;
};

struct TopOptions {
  double interval = 1.0;  // s
  std::size_t count = 0;  // 0: until Ctrl-C
};

struct CancelOptions {
  std::string id, reason = "cancelled from the command line";
};

struct StateOptions {
  std::string id;
  bool steps = false, verbose = false;
  std::string output;
};

struct ScenePutOptions {
  std::string file, name;
};

struct PluginInfoOptions {
  std::string file, robot_file;
};

struct DrawOptions {
  std::string source;  // a plan file or a request's id
  std::string output;
  std::string view = "both", frame = "scene", steps;
  std::optional<double> width, azimuth, elevation;
};

struct SecurityOptions {
  std::string folder;     // of an authority that is to be made
  std::string authority;  // the folder of one that is there
  std::string name, role, output;
  double years = 10.0, days = 365.0;
};

// Each prints to stdout; what went wrong is thrown as a Complaint (terminal.hpp) and printed to stderr by main().
Exit run_robots(const Common& common, const RobotsOptions& options);
Exit run_plan(const Common& common, const PlanOptions& options);
Exit run_replay(const Common& common, const ReplayOptions& options);
Exit run_history(const Common& common, const HistoryOptions& options);
Exit run_top(const Common& common, const TopOptions& options);
Exit run_cancel(const Common& common, const CancelOptions& options);
Exit run_state(const Common& common, const StateOptions& options);
Exit run_scene_put(const Common& common, const ScenePutOptions& options);
Exit run_scene_list(const Common& common);
Exit run_plugin_info(const Common& common, const PluginInfoOptions& options);
Exit run_draw(const Common& common, const DrawOptions& options);
Exit run_doctor(const Common& common);
Exit run_security_init(const SecurityOptions& options);
Exit run_security_issue(const SecurityOptions& options);
Exit run_security_revoke(const SecurityOptions& options);
Exit run_security_list(const Common& common, const SecurityOptions& options);

}  // namespace foothold::cli
