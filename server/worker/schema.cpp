// The schema's own consistency, its form on the wire, and requests under it.
#include "worker/schema.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "text/text.hpp"
#include "worker/loader.hpp"

namespace foothold::server {
namespace {

// As PROTOCOL.md bounds them in requests.
constexpr std::size_t kMostParameters = 64, kLongestName = 64, kLongestValue = 1024;

std::span<const ParameterSpec> specs_of(const PlannerInfo& info) { return {info.parameters, info.parameter_count}; }

[[noreturn]] void refuse(const PlannerInfo& info, const std::string& reason) {
  throw PluginRefused("plugin '" + std::string(info.name) + "' " + reason);
}

void check_spec(const PlannerInfo& info, const ParameterSpec& spec) {
  for (const char* text : {spec.name, spec.unit, spec.default_value, spec.choices, spec.description})
    if (text == nullptr)
      refuse(info, "declares a parameter with a null pointer for a text");
    else if (!is_clean_text(text))
      refuse(info, "declares a parameter with a text that is not UTF-8 without control characters: " + quoted(text));
  const std::string name = "declares parameter '" + std::string(spec.name) + "' ";
  if (*spec.name == '\0') refuse(info, "declares a parameter without a name");
  if (std::string_view(spec.name).size() > kLongestName) refuse(info, name + "with a name of more than 64 octets");
  if (std::string_view(spec.default_value).size() > kLongestValue) refuse(info, name + "with a default of more than 1024 octets");
  if (spec.kind > ParameterKind::kChoice) refuse(info, name + "of unknown kind " + std::to_string(static_cast<int>(spec.kind)));
  const bool number = spec.kind == ParameterKind::kInteger || spec.kind == ParameterKind::kReal;
  if (number && !(std::isfinite(spec.minimum) && std::isfinite(spec.maximum)))
    refuse(info, name + "with bounds that are not finite");
  if (number && spec.minimum > spec.maximum) refuse(info, name + "with a minimum above its maximum");
  if (spec.kind == ParameterKind::kChoice && *spec.choices == '\0') refuse(info, name + "as a choice of nothing");
  try {
    (void)parse_parameter(spec, spec.default_value);
  } catch (const ParameterFault& fault) {
    refuse(info, name + "with a default that it refuses itself: " + fault.message);
  }
}

}  // namespace

std::vector<std::string> words_of(std::string_view list) {
  std::vector<std::string> words;
  while (!list.empty()) {
    const auto bar = std::min(list.find('|'), list.size());
    words.emplace_back(list.substr(0, bar));
    list.remove_prefix(std::min(bar + 1, list.size()));
  }
  return words;
}

void check_info(const PlannerInfo& info) {
  for (const char* text : {info.name, info.version, info.description, info.joints, info.limbs, info.start_needs, info.goal_needs,
                           info.prepare_parameters})
    if (text == nullptr)
      throw PluginRefused("the plugin hands over a null pointer for a text of its PlannerInfo");
    else if (!is_clean_text(text))
      throw PluginRefused("the plugin hands over a text that is not UTF-8 without control characters: " + quoted(text));
  if (*info.name == '\0') throw PluginRefused("the plugin has no name");
  if (*info.version == '\0') refuse(info, "has no version");
  if (info.parameters == nullptr && info.parameter_count != 0) refuse(info, "hands over a null pointer for its parameters");
  if (info.parameter_count > kMostParameters)
    refuse(info, "declares " + std::to_string(info.parameter_count) + " parameters, at most 64 are allowed");
  std::set<std::string_view> names;
  for (const ParameterSpec& spec : specs_of(info)) {
    check_spec(info, spec);
    if (!names.insert(spec.name).second) refuse(info, "declares parameter '" + std::string(spec.name) + "' twice");
  }
  for (const std::string& name : words_of(info.prepare_parameters))
    if (!names.contains(name)) refuse(info, "names '" + name + "' in prepare_parameters but declares no such parameter");
}

msg::RobotInfo describe_robot(const std::string& robot, const PlannerInfo& info) {
  msg::RobotInfo out;
  out.name(robot);
  out.description(info.description);
  out.plugin(info.name);
  out.plugin_version(info.version);
  out.state(msg::READY);
  out.joints(words_of(info.joints));
  out.limbs(words_of(info.limbs));
  out.start_needs(info.start_needs);
  out.goal_needs(info.goal_needs);
  for (const ParameterSpec& spec : specs_of(info)) {
    msg::ParameterSpec& told = out.parameters().emplace_back();
    told.name(spec.name);
    told.kind(static_cast<msg::ParameterKind>(spec.kind));
    told.unit(spec.unit);
    told.default_value(spec.default_value);
    told.minimum(spec.minimum);
    told.maximum(spec.maximum);
    told.choices(words_of(spec.choices));
    told.description(spec.description);
  }
  return out;
}

ParsedParameters parse_parameters(const PlannerInfo& info, const std::vector<msg::Parameter>& given) {
  const auto specs = specs_of(info);
  for (const msg::Parameter& parameter : given)
    if (std::ranges::none_of(specs, [&](const ParameterSpec& spec) { return parameter.name() == spec.name; }))
      throw ParameterFault{ParameterFault::Kind::kUnknown, parameter.name(),
                           "is not a parameter of plugin '" + std::string(info.name) + "'"};

  ParsedParameters out;
  std::map<std::string, Parameters::Value, std::less<>> values;
  const auto prepare_names = words_of(info.prepare_parameters);
  for (const ParameterSpec& spec : specs) {
    const auto found =
        std::ranges::find(given, std::string_view(spec.name), [](const auto& p) { return std::string_view(p.name()); });
    const std::string text = found == given.end() ? spec.default_value : found->value();
    values.emplace(spec.name, parse_parameter(spec, text));
    if (std::ranges::find(prepare_names, spec.name) != prepare_names.end())
      out.prepare_key += std::string(spec.name) + '=' + text + '\n';
    msg::Parameter& told = out.texts.emplace_back();
    told.name(spec.name);
    told.value(text);
  }
  out.values = Parameters(std::move(values));
  return out;
}

}  // namespace foothold::server
