// The test planners (tests/plugins) as tests ask for them.
#pragma once

#include <cstdint>
#include <string>

#include "daemon.hpp"
#include "wire.hpp"

namespace foothold::test {

// Emits as many steps as asked for, at any pace, and heeds its stop token.
inline TestRobot good_robot(const std::string& name, unsigned slots = 1) { return {name, "many", slots, {}}; }

// One that misbehaves as its name says.
inline TestRobot bad_robot(const std::string& plugin) { return {plugin, plugin, 1, plugin == "memory" ? "200 MiB" : ""}; }

// `pause`: s before each step.
inline msg::PlanRequest paced_request(const std::string& robot, std::uint32_t steps, double pause) {
  return request_for(robot, 60.0, {{"steps", std::to_string(steps)}, {"pause_us", std::to_string(static_cast<int>(pause * 1e6))}});
}

// For daemons whose planners are killed on purpose, again and again.
inline constexpr char kNeverQuarantine[] = "workers: {quarantine_crashes: 1000, restart_longest: 0.2}\n";

}  // namespace foothold::test
