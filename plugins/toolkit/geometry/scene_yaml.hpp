// What readers of scene files in YAML share: refusals that name the field and begin with the line. Private to readers: it brings
// yaml-cpp along. Free functions; any thread.
#pragma once

#include <yaml-cpp/yaml.h>

#include <initializer_list>
#include <string>

#include "foothold/errors.hpp"

namespace foothold::geometry {

// Throws InvalidScene for `field`, whose message begins with the node's line.
[[noreturn]] void fail(const YAML::Node& node, const std::string& field, const std::string& reason);
// "field[k]".
std::string at(const std::string& field, std::size_t k);
// `node` is a map of keys among `known`, none given twice. Throws InvalidScene.
void demand_keys(const YAML::Node& node, const std::string& field, std::initializer_list<const char*> known);
// `root` says that it is a scene of this kind. Throws InvalidScene.
void demand_kind(const YAML::Node& root, const std::string& kind);
std::string word(const YAML::Node& node, const std::string& field);  // throws InvalidScene
// Finite and within 10000 (m: beyond that millimetres are lost to rounding). `what` ends the sentence "must be a number". Throws
// InvalidScene.
double number(const YAML::Node& node, const std::string& field, const char* what);

// What `read` makes of the text's root. Throws InvalidScene where the text is no YAML.
template <class Read>
auto read_yaml(const std::string& text, Read&& read) {
  try {
    return read(YAML::Load(text));
  } catch (const YAML::Exception& fault) {
    throw InvalidScene("", "line " + std::to_string(fault.mark.line + 1) + ": " + fault.msg);
  }
}

// The whole file. Throws InvalidScene.
std::string text_of_scene(const std::string& path);

}  // namespace foothold::geometry
