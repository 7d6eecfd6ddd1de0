// Loading a planner's shared library: refused in one sentence, with both values, unless it was built as this program was.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "foothold/export.hpp"

namespace foothold::server {

// The library cannot be used; what() is one sentence for people.
class PluginRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What differs between a plugin's layout and ours, as a sentence's end: "was built for API version 7, this server has 1". Nothing
// if they agree. Of a `theirs` whose size differs only the first two members are read.
std::optional<std::string> abi_mismatch(const PluginAbi& theirs, const PluginAbi& ours = this_abi());

// Loads the library for good: it is never unloaded, a newer one needs a new process. Runs the library's static initialisers.
// Throws PluginRefused. The descriptor lives as long as the process.
const PluginDescriptor& load_plugin(const std::string& path);

}  // namespace foothold::server
