// From config/footholdd.yaml and config/robots/*.yaml to values. What is allowed is in server_file.cpp and robot_files.cpp, key by
// key.
#pragma once

#include <string>
#include <vector>

#include "config/config.hpp"
#include "config/faults.hpp"

namespace foothold::server {

// Throws ConfigError with every fault of the file.
ServerConfig read_server_config(const std::string& file);

// Every *.yaml of `config.robots_dir`, in alphabetical order, the disabled ones too. Throws ConfigError with every fault of all
// of them.
std::vector<RobotConfig> read_robots(const ServerConfig& config);

}  // namespace foothold::server
