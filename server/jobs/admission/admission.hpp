// Whether a request can be taken: every check of idl/PROTOCOL.md P4, each refusal with the field's path and the values.
//
// Paths: members as in foothold.idl joined by dots, elements by index ("goal.contacts[2].frame.orientation", "start.joints[5]");
// the one base without an index ("goal.base.position"); a parameter by its name ("parameters.cycles"), or by its index where the
// name itself is at fault ("parameters[3].name"). Every message begins with the path.
//
// Pure functions; any thread.
#pragma once

#include <foothold.h>

#include <optional>
#include <string>

#include "jobs/ports.hpp"

namespace foothold::server {

using Refusal = std::optional<msg::Error>;

// "<field> <reason>" as an error of that code.
msg::Error refuse(std::uint16_t code, const std::string& field, const std::string& reason);

// What can be said of the request alone: ids, text, sizes, numbers, budget. In the order of the IDL; the whole's size last.
Refusal check_form(const msg::PlanRequest& request, double budget_max);

// Against what the robot's planner declares. The same rules as in the worker (foothold::parse_parameter).
Refusal check_parameters(const std::vector<msg::Parameter>& parameters, const std::vector<msg::ParameterSpec>& specs);

// Known, and able to plan now.
Refusal check_robot(const std::string& robot, const RobotStatus& status);

// Known name and revision; writes the newest revision's hash into a request that leaves it empty.
Refusal check_scene(msg::PlanRequest& request, const SceneShelf& scenes);

// All of the above: form, robot, scene, parameters.
Refusal admit(msg::PlanRequest& request, double budget_max, const RobotStatus& status, const SceneShelf& scenes);

// The given values, and the defaults of what is not given, in the order of `specs`.
std::vector<msg::Parameter> complete_parameters(const std::vector<msg::Parameter>& given,
                                                const std::vector<msg::ParameterSpec>& specs);

// What the journal keeps of a request that is never planned: ids and the names that keep to the limits.
msg::PlanRequest essence(const msg::PlanRequest& request);

}  // namespace foothold::server
