// Parameters of a planner: the schema that it declares and the values of one request, complete and in range when plan() sees them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace foothold {

enum class ParameterKind : std::uint32_t { kFlag, kInteger, kReal, kText, kChoice };

// One parameter that a planner takes. Plain data with static lifetime: it crosses the plugin's border (see export.hpp).
struct ParameterSpec {
  const char* name;
  ParameterKind kind;
  const char* unit;           // "m", "rad", "1", "" for words and flags
  const char* default_value;  // as text; valid under this very schema
  double minimum;             // of kInteger and kReal, included
  double maximum;
  const char* choices;      // of kChoice: words separated by '|'
  const char* description;  // one sentence
};

// The values of one request. Reading a name that the schema does not declare, or as another kind, throws std::logic_error:
// that is a mistake in the plugin. Immutable after construction, so any thread may read it.
class Parameters {
 public:
  using Value = std::variant<bool, std::int64_t, double, std::string>;

  Parameters() = default;
  explicit Parameters(std::map<std::string, Value, std::less<>> values) : values_(std::move(values)) {}

  bool flag(std::string_view name) const;
  std::int64_t integer(std::string_view name) const;
  double real(std::string_view name) const;              // SI unit of the schema
  const std::string& text(std::string_view name) const;  // of kText and kChoice

  const std::map<std::string, Value, std::less<>>& values() const { return values_; }

 private:
  template <class T>
  const T& get(std::string_view name) const;
  std::map<std::string, Value, std::less<>> values_;
};

// Thrown by parse_parameters; the worker and the server turn it into a refusal that names the field.
struct ParameterFault {
  enum class Kind { kUnknown, kNotOfKind, kOutOfRange };
  Kind kind;
  std::string name;
  std::string message;
};

// One value from text under its spec. Throws ParameterFault.
Parameters::Value parse_parameter(const ParameterSpec& spec, std::string_view text);

}  // namespace foothold
