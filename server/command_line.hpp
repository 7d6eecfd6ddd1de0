// footholdd's command line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace foothold::server {

// Exit codes, as --help tells them.
enum ExitCode : int {
  kStopped = 0,           // told to stop, or --check found nothing
  kFailed = 1,            // a fault of the server itself; the log says what
  kBadConfiguration = 2,  // command line, footholdd.yaml or a robot's file
  kStateUnusable = 3,     // the state folder or the journal
  kNetworkUnusable = 4,   // the bus cannot be opened
};

// What is given goes before the configuration file.
struct CommandLine {
  std::string config;
  std::string state_dir;
  std::string vendor;
  std::optional<std::uint32_t> domain;
  bool check = false;
  std::optional<int> exit;  // --help and --version have been answered, or the words were wrong
};

CommandLine parse_command_line(int count, char** words);

}  // namespace foothold::server
