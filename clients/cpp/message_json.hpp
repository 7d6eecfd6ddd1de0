// Private: any message as JSON and back, by the members that fields.hpp lists. Heavy: include it in plan_file.cpp alone.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "foothold/client/nearest_name.hpp"
#include "foothold/client/plan_file.hpp"
#include "foothold/msg/errors.hpp"
#include "foothold/msg/fields.hpp"
#include "foothold/msg/ids.hpp"

namespace foothold::client {

using Json = nlohmann::ordered_json;

// The names of an enumeration in the order of its values.
template <class E>
std::vector<std::string_view> names_of() {
  if constexpr (std::is_same_v<E, msg::ShapeKind>) return {"BOX", "CAPSULE", "SPHERE", "POLYGON"};
  if constexpr (std::is_same_v<E, msg::ParameterKind>) return {"FLAG", "INTEGER", "REAL", "TEXT", "CHOICE"};
  if constexpr (std::is_same_v<E, msg::SceneState>) return {"STORED", "REFUSED"};
  if constexpr (std::is_same_v<E, msg::RobotState>) return {"READY", "QUARANTINED", "UNAVAILABLE"};
  if constexpr (std::is_same_v<E, msg::State>) {
    std::vector<std::string_view> names;
    for (std::uint32_t state = msg::UNKNOWN; state <= msg::REJECTED; ++state)
      names.push_back(msg::state_name(static_cast<msg::State>(state)));
    return names;
  }
}

// ------------------------------------------------------------------------------------------- to JSON

inline Json to_json(const std::string& text) { return text; }
inline Json to_json(bool flag) { return flag; }
inline Json to_json(const msg::Id& id) { return msg::to_hex(id); }

inline Json to_json(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  return number;
}

template <std::integral N>
requires(!std::same_as<N, bool>) Json to_json(N number) { return number; }

template <class E>
requires std::is_enum_v<E> Json to_json(E value) {
  const auto names = names_of<E>();
  const auto index = static_cast<std::size_t>(value);
  return index < names.size() ? Json(names[index]) : Json(index);
}

template <class T>
Json to_json(const std::vector<T>& list);

template <msg::Struct M>
Json to_json(const M& message) {
  Json object = Json::object();
  msg::fields(message, [&](const char* name, const auto& value) { object[name] = to_json(value); });
  return object;
}

template <class T>
Json to_json(const std::vector<T>& list) {
  Json array = Json::array();
  for (const auto& item : list) array.push_back(to_json(item));
  return array;
}

// Octets that are no UTF-8 become U+FFFD: JSON cannot carry them.
inline std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

// ------------------------------------------------------------------------------------------- from JSON

// Where a value stands: "plan.json: steps[3].cost".
struct Place {
  std::string origin, path;
  Place member(std::string_view name) const { return {origin, path.empty() ? std::string(name) : path + "." + std::string(name)}; }
  Place item(std::size_t index) const { return {origin, path + "[" + std::to_string(index) + "]"}; }
  [[noreturn]] void refuse(const std::string& reason) const {
    throw PlanFileError(origin + ": " + (path.empty() ? "" : path + ": ") + reason);
  }
  void expect(bool holds, const Json& json, const char* wanted) const {
    if (!holds) refuse(std::string("expected ") + wanted + ", not " + (json.is_primitive() ? dump(json) : json.type_name()));
  }
};

inline void from_json(const Json& json, std::string& text, const Place& place) {
  place.expect(json.is_string(), json, "a string");
  text = json.get<std::string>();
}

inline void from_json(const Json& json, bool& flag, const Place& place) {
  place.expect(json.is_boolean(), json, "true or false");
  flag = json.get<bool>();
}

inline void from_json(const Json& json, double& number, const Place& place) {
  if (json == "nan")
    number = std::numeric_limits<double>::quiet_NaN();
  else if (json == "inf")
    number = std::numeric_limits<double>::infinity();
  else if (json == "-inf")
    number = -std::numeric_limits<double>::infinity();
  else {
    place.expect(json.is_number(), json, "a number");
    number = json.get<double>();
  }
}

template <std::integral N>
requires(!std::same_as<N, bool>) void from_json(const Json& json, N& number, const Place& place) {
  place.expect(json.is_number_integer(), json, "an integer");
  const bool fits =
      json.is_number_unsigned() ? std::in_range<N>(json.get<std::uint64_t>()) : std::in_range<N>(json.get<std::int64_t>());
  if (!fits) place.refuse(dump(json) + " does not fit");
  number = json.get<N>();
}

inline void from_json(const Json& json, msg::Id& id, const Place& place) {
  place.expect(json.is_string(), json, "32 hexadecimal digits");
  const auto read = msg::id_from_hex(json.get_ref<const std::string&>());
  place.expect(read.has_value(), json, "32 hexadecimal digits");
  id = *read;
}

template <class E>
requires std::is_enum_v<E>
void from_json(const Json& json, E& value, const Place& place) {
  place.expect(json.is_string(), json, "a name");
  const auto names = names_of<E>();
  const auto& text = json.get_ref<const std::string&>();
  const auto found = std::ranges::find(names, text);
  if (found == names.end()) place.refuse("'" + text + "' is none of its values" + suggestion(text, names));
  value = static_cast<E>(found - names.begin());
}

template <class T>
void from_json(const Json& json, std::vector<T>& list, const Place& place);

template <msg::Struct M>
void from_json(const Json& json, M& message, const Place& place) {
  place.expect(json.is_object(), json, "an object");
  std::vector<std::string_view> names;
  msg::fields(message, [&](const char* name, auto& value) {
    names.emplace_back(name);
    const auto member = json.find(name);
    if (member == json.end()) place.member(name).refuse("is missing");
    from_json(*member, value, place.member(name));
  });
  for (const auto& [name, value] : json.items())
    if (std::ranges::find(names, name) == names.end()) place.member(name).refuse("is not known" + suggestion(name, names));
}

template <class T>
void from_json(const Json& json, std::vector<T>& list, const Place& place) {
  place.expect(json.is_array(), json, "a list");
  list.clear();
  list.reserve(json.size());
  for (const Json& item : json) {
    const Place at = place.item(list.size());
    from_json(item, list.emplace_back(), at);
  }
}

}  // namespace foothold::client
