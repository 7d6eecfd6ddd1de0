// A plugin's parameter schema: judged once at loading, told to clients, and applied to each request.
#pragma once

#include <worker.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "foothold/export.hpp"

namespace foothold::server {

// Throws PluginRefused with the parameter's name: a null pointer, an empty or repeated name, bounds the wrong way round, a default
// that its own schema refuses, a choice without choices, a name in prepare_parameters that is not declared.
void check_info(const PlannerInfo& info);

// Name, version, limbs, joints, needs and schema as clients see them. `robot` is the name that requests say.
msg::RobotInfo describe_robot(const std::string& robot, const PlannerInfo& info);

// The words of a list separated by '|'.
std::vector<std::string> words_of(std::string_view list);

// The values of one request with the defaults of what it leaves out.
struct ParsedParameters {
  Parameters values;
  std::vector<msg::Parameter> texts;  // all of them, in the schema's order
  std::string prepare_key;            // those that prepare() reads
};
// Throws ParameterFault.
ParsedParameters parse_parameters(const PlannerInfo& info, const std::vector<msg::Parameter>& given);

}  // namespace foothold::server
