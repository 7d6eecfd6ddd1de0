// What `foothold doctor` looks at. Each check reads its surroundings and tells what it found; none changes anything.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"

namespace foothold::cli {

struct Finding {
  enum class Level { kOk, kWarn, kFail };
  Level level;
  std::string subject;  // a word or two
  std::string message;  // what is so, with the values
  std::string advice;   // what to do; empty where nothing is to be done
};
using Findings = std::vector<Finding>;

struct Interface {
  std::string name;
  bool up = false, loopback = false;
  std::vector<std::string> addresses;  // IPv4
};

// The machine as the checks see it: tests give one of their own.
struct Surroundings {
  std::filesystem::path proc = "/proc", shm = "/dev/shm";
  std::function<std::optional<std::string>(const std::string&)> variable;  // of the environment; set and not empty
  std::vector<Interface> interfaces;
};
Surroundings this_machine();

// Loopback is up; what other interfaces there are.
Findings check_interfaces(const Surroundings& around);
// Whether DDS traffic can leave this host, by the network configuration that is in use.
Findings check_exposure(const Common& common);
// Whether DDS Security is on; what is open without it, or whether the credentials are in order.
Findings check_security(const Common& common);
// Variables of the vendors, of ROS and of foothold, and what they do to us.
Findings check_environment(const Surroundings& around, const Common& common);
// How many participants the domain has on this host, of those that it can have; whether its ports can be taken by others.
Findings check_participants(const Surroundings& around, const Common& common);
Findings check_socket_buffers(const Surroundings& around);
// Shared memory that killed DDS programs left.
Findings check_shared_memory(const Surroundings& around);
// Both vendors' libraries load, and whether a server answers through each. Waits.
Findings check_servers(const Common& common);

}  // namespace foothold::cli
