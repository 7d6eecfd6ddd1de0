// Which shipped requests the storm's clients ask for, and how often.
#pragma once

#include <string>
#include <vector>

#include "daemon.hpp"

namespace foothold::faults {

// The robots of config/robots whose planners are built, each as a robot of a test's server.
std::vector<test::TestRobot> shipped_robots();

// Asks a server without faults for every shipped request of its robots, and writes to `file` those that it plans within two
// seconds, so often that each takes the same share of the time. Gives a line for each of the others. Throws std::runtime_error if a
// robot of the server has none.
std::vector<std::string> write_choices(const test::DaemonOptions& server, const std::string& file);

}  // namespace foothold::faults
