// A plan as one JSON document: the request, the final event with its summary, the scene's shapes and every step. `foothold plan -o`
// writes it, `foothold draw` and `foothold replay` read it. Numbers keep every bit; what is not finite is written as "nan", "inf"
// or "-inf"; ids are 32 hexadecimal digits; enumerations are their names in foothold.idl. Text that is no UTF-8 loses those octets.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "foothold/client/plan_record.hpp"

namespace foothold::client {

// what() is "file: path.to.field: reason".
class PlanFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

std::string plan_to_json(const PlanRecord& plan);
// `origin` names the text in errors. Throws PlanFileError: not JSON, another format or version, a field missing, unknown or of the
// wrong type. Any thread.
PlanRecord plan_from_json(std::string_view text, const std::string& origin);

// Written beside and renamed, so that a file is whole or not there. Throws PlanFileError.
void write_plan_file(const std::string& path, const PlanRecord& plan);
PlanRecord read_plan_file(const std::string& path);

// One message as one line of JSON, for scripts.
std::string to_json_line(const msg::Step& step);
std::string to_json_line(const msg::PlanEvent& event);
std::string to_json_line(const msg::RobotInfo& robot);
std::string to_json_line(const msg::SceneStatus& scene);
std::string to_json_line(const msg::ServerInfo& server);
// {"request": ..., "event": ...}, without scene and steps.
std::string to_json_line(const PlanRecord& plan);

}  // namespace foothold::client
