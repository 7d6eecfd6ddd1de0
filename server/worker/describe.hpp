// What a plugin's file holds, as JSON for people and tools: foothold-worker --describe.
#pragma once

#include <string>

namespace foothold::server {

// Writes one JSON object to stdout: abi, info and parameters, or {"refused": {...}}. `robot_file` may be empty; otherwise its model
// is handed to the planner's constructor too. Returns the exit code: 0, or 1 if refused.
int describe(const std::string& plugin, const std::string& robot_file);

}  // namespace foothold::server
