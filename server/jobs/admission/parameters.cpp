// The parameters of a request against what the planner declares.
#include "foothold/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "jobs/admission/admission.hpp"
#include "text/text.hpp"

namespace foothold::server {
namespace {

// The plugin interface's view of a declared parameter; it points into `spec` and `choices`.
ParameterSpec as_declared(const msg::ParameterSpec& spec, std::string& choices) {
  for (const auto& choice : spec.choices()) choices += (choices.empty() ? "" : "|") + choice;
  return {.name = spec.name().c_str(),
          .kind = static_cast<ParameterKind>(spec.kind()),
          .unit = spec.unit().c_str(),
          .default_value = spec.default_value().c_str(),
          .minimum = spec.minimum(),
          .maximum = spec.maximum(),
          .choices = choices.c_str(),
          .description = spec.description().c_str()};
}

std::string known_names(const std::vector<msg::ParameterSpec>& specs) {
  if (specs.empty()) return "takes none";
  std::string names = "takes ";
  for (const auto& spec : specs) names += (&spec == &specs.front() ? "" : ", ") + spec.name();
  return names;
}

std::uint16_t code_of(ParameterFault::Kind kind) {
  switch (kind) {
    case ParameterFault::Kind::kUnknown:
      return msg::UNKNOWN_PARAMETER;
    case ParameterFault::Kind::kNotOfKind:
      return msg::MALFORMED;
    case ParameterFault::Kind::kOutOfRange:
      return msg::PARAMETER_OUT_OF_RANGE;
  }
  return msg::MALFORMED;
}

Refusal check_value(const std::string& field, const msg::ParameterSpec& spec, const std::string& text) {
  std::string choices;
  const ParameterSpec declared = as_declared(spec, choices);
  try {
    const auto value = parse_parameter(declared, text);
    // A planner may declare an endless range; no number of a request may be infinite all the same.
    if (const double* real = std::get_if<double>(&value); real != nullptr && !std::isfinite(*real))
      return refuse(msg::NOT_FINITE, field, "must be finite, is " + quoted(text));
  } catch (const ParameterFault& fault) {
    if (spec.kind() == msg::REAL && fault.kind == ParameterFault::Kind::kOutOfRange &&
        !std::isfinite(std::strtod(text.c_str(), nullptr)))
      return refuse(msg::NOT_FINITE, field, "must be finite, is " + quoted(text));
    return refuse(code_of(fault.kind), field, fault.message);
  }
  return {};
}

}  // namespace

Refusal check_parameters(const std::vector<msg::Parameter>& parameters, const std::vector<msg::ParameterSpec>& specs) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string& name = parameters[i].name();
    const std::string field = "parameters." + name;
    const auto spec = std::ranges::find_if(specs, [&](const auto& s) { return s.name() == name; });
    if (spec == specs.end())
      return refuse(msg::UNKNOWN_PARAMETER, field, "is not a parameter of this robot's planner, which " + known_names(specs));
    const auto same = [&](const auto& other) { return other.name() == name; };
    if (std::any_of(parameters.begin(), parameters.begin() + static_cast<std::ptrdiff_t>(i), same))
      return refuse(msg::MALFORMED, field, "must be given once, is given again as parameters[" + std::to_string(i) + "]");
    if (auto fault = check_value(field, *spec, parameters[i].value())) return fault;
  }
  return {};
}

std::vector<msg::Parameter> complete_parameters(const std::vector<msg::Parameter>& given,
                                                const std::vector<msg::ParameterSpec>& specs) {
  std::vector<msg::Parameter> all;
  all.reserve(specs.size());
  for (const auto& spec : specs) {
    const auto found = std::ranges::find_if(given, [&](const auto& p) { return p.name() == spec.name(); });
    msg::Parameter& parameter = all.emplace_back();
    parameter.name(spec.name());
    parameter.value(found == given.end() ? spec.default_value() : found->value());
  }
  return all;
}

}  // namespace foothold::server
