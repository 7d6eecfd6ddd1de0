// Requests in the log.
#include "request_log.hpp"

#include <cstdio>

#include "foothold/msg/errors.hpp"
#include "log/log.hpp"

namespace foothold::server {
namespace {

std::string seconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6f", value);
  return text;
}

}  // namespace

void RequestLog::on_ended(const EndedRequest& ended) {
  const msg::PlanEvent& event = ended.event;
  const std::string id = msg::to_hex(ended.request.id()), client = msg::to_hex(ended.request.client());
  const std::string state(msg::state_name(event.state())), steps = std::to_string(event.steps());
  const std::string waited = seconds(ended.waited), planned = ended.ran ? seconds(ended.planned) : "";
  const bool bad = event.state() == msg::CRASHED || ended.killed;
  log::say(bad ? log::Level::kWarn : log::Level::kInfo, "request ended " + state,
           {{"request", id},
            {"robot", ended.request.robot()},
            {"unit", ended.request.unit()},
            {"client", client},
            {"state", state},
            {"error", event.error().name()},
            {"field", event.error().field()},
            {"steps", steps},
            {"waited", waited},
            {"planned", planned}});
}

}  // namespace foothold::server
