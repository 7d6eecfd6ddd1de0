// Plans as JSON documents.
#include "foothold/client/plan_file.hpp"

#include "foothold/client/whole_file.hpp"
#include "message_json.hpp"

namespace foothold::client {
namespace {

constexpr char kFormat[] = "foothold-plan";
constexpr int kVersion = 1;

// One item a line, so that steps can be found and compared with line tools.
template <class T>
std::string lines(const std::vector<T>& list) {
  std::string text = "[";
  for (const T& item : list) text += (text.size() > 1 ? ",\n" : "\n") + dump(to_json(item));
  return text + (list.empty() ? "]" : "\n]");
}

const Json& part(const Json& document, const char* name, const Place& place) {
  const auto found = document.find(name);
  if (found == document.end()) place.member(name).refuse("is missing");
  return *found;
}

Json parse(std::string_view text, const Place& place) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    const auto lines_before =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size())), '\n');
    place.refuse("line " + std::to_string(lines_before + 1) + ": not JSON");
  } catch (const Json::out_of_range& error) {
    place.refuse(std::string("a number is too large: ") + error.what());
  }
}

}  // namespace

std::string plan_to_json(const PlanRecord& plan) {
  return std::string("{\n\"format\": \"") + kFormat + "\",\n\"version\": " + std::to_string(kVersion) +
         ",\n\"request\": " + dump(to_json(plan.request)) + ",\n\"final_event\": " + dump(to_json(plan.final_event)) +
         ",\n\"scene\": " + lines(plan.scene) + ",\n\"steps\": " + lines(plan.steps) + "\n}\n";
}

PlanRecord plan_from_json(std::string_view text, const std::string& origin) {
  const Place place{origin, ""};
  const Json document = parse(text, place);
  place.expect(document.is_object(), document, "an object");
  if (part(document, "format", place) != kFormat)
    place.member("format").refuse("expected \"" + std::string(kFormat) + "\", not " + dump(document["format"]));
  if (part(document, "version", place) != kVersion)
    place.member("version").refuse("this program reads version " + std::to_string(kVersion) + ", not " + dump(document["version"]));
  constexpr std::array<std::string_view, 6> kParts = {"format", "version", "request", "final_event", "scene", "steps"};
  for (const auto& [name, value] : document.items())
    if (std::ranges::find(kParts, name) == kParts.end()) place.member(name).refuse("is not known" + suggestion(name, kParts));
  PlanRecord plan;
  from_json(part(document, "request", place), plan.request, place.member("request"));
  from_json(part(document, "final_event", place), plan.final_event, place.member("final_event"));
  from_json(part(document, "scene", place), plan.scene, place.member("scene"));
  from_json(part(document, "steps", place), plan.steps, place.member("steps"));
  return plan;
}

void write_plan_file(const std::string& path, const PlanRecord& plan) {
  try {
    write_whole_file(path, plan_to_json(plan));
  } catch (const std::system_error& error) {
    throw PlanFileError(path + ": cannot be written: " + error.code().message());
  }
}

PlanRecord read_plan_file(const std::string& path) {
  std::string text;
  try {
    text = read_whole_file(path);
  } catch (const std::system_error& error) {
    throw PlanFileError(path + ": cannot be read: " + error.code().message());
  }
  return plan_from_json(text, path);
}

std::string to_json_line(const msg::Step& step) { return dump(Json{{"step", to_json(step)}}); }
std::string to_json_line(const msg::PlanEvent& event) { return dump(Json{{"event", to_json(event)}}); }
std::string to_json_line(const msg::RobotInfo& robot) { return dump(Json{{"robot", to_json(robot)}}); }
std::string to_json_line(const msg::SceneStatus& scene) { return dump(Json{{"scene", to_json(scene)}}); }
std::string to_json_line(const PlanRecord& plan) {
  return dump(Json{{"request", to_json(plan.request)}, {"event", to_json(plan.final_event)}});
}
std::string to_json_line(const msg::ServerInfo& server) { return dump(Json{{"server", to_json(server)}}); }

}  // namespace foothold::client
