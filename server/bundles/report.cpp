// The report of a bundle.
#include "bundles/report.hpp"

#include <sys/utsname.h>

#include <ctime>

#include "foothold/msg/errors.hpp"
#include "foothold/msg/times.hpp"

namespace foothold::server {
namespace {

constexpr std::string_view kLastWords = "its last words: ";  // as Worker puts them into its error
constexpr std::string_view kBetween = " | ";

std::string host() {
  utsname name{};
  if (uname(&name) != 0) return {};
  return std::string(name.nodename) + ", " + name.sysname + " " + name.release + " " + name.machine;
}

}  // namespace

std::string signal_in(const std::string& message) {
  for (const std::string_view before : {"died of SIG", "signal SIG"}) {
    const auto at = message.find(before);
    if (at == std::string::npos) continue;
    const auto begin = at + before.size() - 3;
    return message.substr(begin, message.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789", begin) - begin);
  }
  return {};
}

std::vector<std::string> last_words_in(const std::string& message) {
  std::vector<std::string> lines;
  const auto found = message.find(kLastWords);
  if (found == std::string::npos) return lines;
  for (std::size_t at = found + kLastWords.size(); at <= message.size();) {
    const auto end = std::min(message.find(kBetween, at), message.size());
    lines.push_back(message.substr(at, end - at));
    at = end + kBetween.size();
  }
  return lines;
}

std::string report_of(const Incident& incident) {
  const msg::PlanRequest& request = incident.request;
  const msg::PlanEvent& end = incident.end;
  const std::string& message = end.error().message();
  std::string text;
  const auto line = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += std::string(name) + ": " + value + "\n";
  };
  line("why", incident.why);
  line("when", msg::utc_text(end.stamp() / 1'000'000'000, "%Y-%m-%dT%H:%M:%SZ"));
  line("request", msg::to_hex(request.id()));
  line("client", msg::to_hex(request.client()));
  line("robot", request.robot());
  line("unit", request.unit());
  line("scene", request.scene());
  line("scene_sha256", request.scene_revision());
  line("state", std::string(msg::state_name(end.state())));
  line("error", end.error().name());
  line("message", message.substr(0, message.find("; its last words: ")));
  line("signal", signal_in(message));
  line("steps", std::to_string(end.steps()));
  line("waited_s", std::to_string(incident.waited));
  line("planned_s", std::to_string(incident.planned));
  line("budget_s", std::to_string(request.budget()));
  line("seed", std::to_string(request.seed()));
  for (const msg::Parameter& parameter : end.summary().parameters())
    line(("parameter." + parameter.name()).c_str(), parameter.value());
  line("planner", end.summary().plugin() + " " + end.summary().plugin_version());
  line("server", incident.server);
  line("host", host());
  text += "\nPlan it again, and compare: foothold replay FOLDER\n";
  const auto part = [&](const char* title, const std::vector<std::string>& lines) {
    if (lines.empty()) return;
    text += std::string("\n") + title + "\n";
    for (const std::string& each : lines) text += "  " + each + "\n";
  };
  part("What the worker said last (a crash: signal, address, backtrace):", last_words_in(message));
  part("The log of the server up to then:", incident.log);
  return text;
}

}  // namespace foothold::server
