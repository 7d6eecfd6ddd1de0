// Reading parameters: typed access for planners, and text to value under a schema.
#include "foothold/parameters.hpp"

#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace foothold {
namespace {

std::string bounds(const ParameterSpec& spec) {
  std::ostringstream out;
  out.precision(15);  // enough that no bound is told as another number
  out << spec.minimum << " to " << spec.maximum;
  const std::string_view unit = spec.unit;
  if (!unit.empty() && unit != "1") out << ' ' << unit;
  return out.str();
}

[[noreturn]] void fault(ParameterFault::Kind kind, const ParameterSpec& spec, const std::string& message) {
  throw ParameterFault{kind, spec.name, message};
}

template <class T>
T parse_number(const ParameterSpec& spec, std::string_view text, const char* what) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole_text = end == text.data() + text.size();
  // Too large or too fine for 64 bits: a number of the right kind nevertheless.
  const bool beyond = error == std::errc::result_out_of_range && whole_text;
  if (!beyond && (error != std::errc{} || !whole_text))
    fault(ParameterFault::Kind::kNotOfKind, spec, "must be " + std::string(what) + ", is '" + std::string(text) + "'");
  // A double does not tell every 64-bit integer from its neighbours, a long double does.
  const auto exact = static_cast<long double>(value);
  if (beyond || !(exact >= spec.minimum && exact <= spec.maximum))
    fault(ParameterFault::Kind::kOutOfRange, spec, "must be " + bounds(spec) + ", is " + std::string(text));
  return value;
}

bool is_choice(std::string_view choices, std::string_view word) {
  while (!choices.empty()) {
    const auto bar = choices.find('|');
    if (choices.substr(0, bar) == word) return true;
    if (bar == std::string_view::npos) break;
    choices.remove_prefix(bar + 1);
  }
  return false;
}

}  // namespace

template <class T>
const T& Parameters::get(std::string_view name) const {
  const auto found = values_.find(name);
  if (found == values_.end()) throw std::logic_error("parameter '" + std::string(name) + "' is not in the plugin's schema");
  const T* value = std::get_if<T>(&found->second);
  if (value == nullptr)
    throw std::logic_error("parameter '" + std::string(name) + "' is read as another kind than its schema says");
  return *value;
}

bool Parameters::flag(std::string_view name) const { return get<bool>(name); }
std::int64_t Parameters::integer(std::string_view name) const { return get<std::int64_t>(name); }
double Parameters::real(std::string_view name) const { return get<double>(name); }
const std::string& Parameters::text(std::string_view name) const { return get<std::string>(name); }

Parameters::Value parse_parameter(const ParameterSpec& spec, std::string_view text) {
  switch (spec.kind) {
    case ParameterKind::kFlag:
      if (text == "true") return true;
      if (text == "false") return false;
      fault(ParameterFault::Kind::kNotOfKind, spec, "must be true or false, is '" + std::string(text) + "'");
    case ParameterKind::kInteger:
      return parse_number<std::int64_t>(spec, text, "a whole number");
    case ParameterKind::kReal:
      return parse_number<double>(spec, text, "a number");
    case ParameterKind::kChoice:
      if (!is_choice(spec.choices, text))
        fault(ParameterFault::Kind::kOutOfRange, spec,
              "must be one of " + std::string(spec.choices) + ", is '" + std::string(text) + "'");
      return std::string(text);
    case ParameterKind::kText:
      return std::string(text);
  }
  throw std::logic_error("parameter '" + std::string(spec.name) + "' has no kind");
}

}  // namespace foothold
