// A picture of the fleet as JSON, for scripts.
#include <nlohmann/json.hpp>

#include "foothold/msg/errors.hpp"
#include "top/fleet.hpp"

namespace foothold::cli {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(msg::RobotState state) {
  if (state == msg::READY) return "READY";
  return state == msg::QUARANTINED ? "QUARANTINED" : "UNAVAILABLE";
}

Json to_json(const FleetPicture::Request& request) {
  const msg::PlanEvent& event = request.event;
  return {{"id", msg::to_hex(event.request())},
          {"client", msg::to_hex(event.client())},
          {"server", request.server},
          {"robot", event.robot()},
          {"unit", event.unit()},
          {"state", msg::state_name(event.state())},
          {"age", request.age},
          {"steps", event.steps()},
          {"error", event.error().name()}};
}

}  // namespace

std::string to_json_line(const FleetPicture& picture) {
  Json out = {{"servers", Json::array()}, {"robots", Json::array()}, {"requests", Json::array()}, {"ended", Json::object()}};
  for (const auto& [info, alive] : picture.servers)
    out["servers"].push_back({{"name", info.name()},
                              {"id", msg::to_hex(info.key())},
                              {"alive", alive},
                              {"version", info.version()},
                              {"uptime", info.uptime()},
                              {"queued", info.queued()},
                              {"running", info.running()},
                              {"slots", info.slots()},
                              {"stopping", info.stopping()}});
  for (const auto& robot : picture.robots)
    out["robots"].push_back({{"name", robot.info.name()},
                             {"server", robot.server},
                             {"state", name_of(robot.info.state())},
                             {"reason", robot.info.reason()},
                             {"running", robot.running},
                             {"slots", robot.info.slots()},
                             {"plugin", robot.info.plugin() + " " + robot.info.plugin_version()}});
  for (const auto& request : picture.requests) out["requests"].push_back(to_json(request));
  for (const auto& [state, count] : picture.ended_by_state) out["ended"][state] = count;
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace foothold::cli
