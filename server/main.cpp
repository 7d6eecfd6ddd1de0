// footholdd: reads the configuration, opens the server, runs it until a signal.
#include <boost/asio/io_context.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "command_line.hpp"
#include "config/reading.hpp"
#include "daemon.hpp"
#include "exposure.hpp"
#include "log/log.hpp"

namespace foothold::server {
namespace fs = std::filesystem;

namespace {

// The first of these that is there, seen from the program's own folder; else the last.
std::string beside_program(std::initializer_list<const char*> places) {
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  std::string last;
  for (const char* place : places) {
    last = (folder / place).lexically_normal().string();
    if (fs::exists(last)) break;
  }
  return last;
}

ServerConfig configured(const CommandLine& line) {
  ServerConfig config = read_server_config(line.config);
  if (!line.state_dir.empty()) config.state_dir = fs::absolute(line.state_dir).lexically_normal().string();
  if (!line.vendor.empty()) config.dds.vendor = line.vendor;
  if (line.domain) config.dds.domain = *line.domain;
  if (config.plugin_dir.empty()) config.plugin_dir = beside_program({"../lib/foothold/plugins", "../plugins"});
  if (config.worker.empty()) config.worker = beside_program({"../lib/foothold/foothold-worker", "foothold-worker"});
  if (const char* systemd = std::getenv("STATE_DIRECTORY"); config.state_dir.empty() && systemd != nullptr)
    config.state_dir = systemd;
  if (config.state_dir.empty()) {
    Faults faults;
    faults.add(line.config, 0, "state_dir", "is missing; name a folder there or by --state-dir");
    throw ConfigError(faults);
  }
  if (const std::string fault = fault_of_security(config.dds); !fault.empty()) {
    Faults faults;
    faults.add(line.config, 0, "dds.security", fault);
    throw ConfigError(faults);
  }
  return config;
}

Settings settings_of(const CommandLine& line) {
  Settings settings{configured(line), {}};
  settings.robots = read_robots(settings.server);
  return settings;
}

int serve(const CommandLine& line) {
  // A reload that is asked for before the server can do it must not end it.
  std::signal(SIGHUP, SIG_IGN);
  Settings settings = settings_of(line);
  if (line.check) {
    std::printf("%s and %zu robots: no fault\n", line.config.c_str(), settings.robots.size());
    return kStopped;
  }
  log::open(settings.server.log_level);
  std::signal(SIGPIPE, SIG_IGN);
  boost::asio::io_context loop(1);
  Daemon daemon(loop, std::move(settings), [line] { return settings_of(line); });
  daemon.run();
  return kStopped;
}

}  // namespace
}  // namespace foothold::server

int main(int count, char** words) {
  using namespace foothold::server;
  const CommandLine line = parse_command_line(count, words);
  if (line.exit) return *line.exit;
  const auto fail = [](const std::exception& error, int code) {
    std::fprintf(stderr, "%s\n", error.what());
    return code;
  };
  try {
    return serve(line);
  } catch (const ConfigError& error) {
    return fail(error, kBadConfiguration);
  } catch (const StateError& error) {
    return fail(error, kStateUnusable);
  } catch (const JournalError& error) {
    return fail(error, kStateUnusable);
  } catch (const foothold::sqlite::Error& error) {
    return fail(error, kStateUnusable);
  } catch (const foothold::transport::BusError& error) {
    return fail(error, kNetworkUnusable);
  } catch (const std::exception& error) {
    return fail(error, kFailed);
  }
}
