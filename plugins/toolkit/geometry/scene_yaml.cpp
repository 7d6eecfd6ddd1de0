// Fields, lines and reasons.
#include "geometry/scene_yaml.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

namespace foothold::geometry {
namespace {

constexpr double kFarthest = 1e4;

}  // namespace

void fail(const YAML::Node& node, const std::string& field, const std::string& reason) {
  throw InvalidScene(field, "line " + std::to_string(node.Mark().line + 1) + ": " + reason);
}

std::string at(const std::string& field, std::size_t k) { return field + "[" + std::to_string(k) + "]"; }

void demand_keys(const YAML::Node& node, const std::string& field, std::initializer_list<const char*> known) {
  if (!node.IsMap()) fail(node, field, "must be a map");
  std::set<std::string> seen;
  for (const auto& entry : node) {
    const auto key = entry.first.as<std::string>("");
    const std::string path = field.empty() ? key : field + "." + key;
    if (std::none_of(known.begin(), known.end(), [&](const char* k) { return key == k; }))
      fail(entry.first, path, "is not a known key");
    if (!seen.insert(key).second) fail(entry.first, path, "is given twice");
  }
}

void demand_kind(const YAML::Node& root, const std::string& kind) {
  if (!root["kind"]) fail(root, "kind", "is missing; this reader takes '" + kind + "'");
  if (const std::string is = word(root["kind"], "kind"); is != kind)
    fail(root["kind"], "kind", "must be " + kind + ", is '" + is + "'");
}

std::string word(const YAML::Node& node, const std::string& field) {
  if (!node.IsScalar()) fail(node, field, "must be a word");
  return node.Scalar();
}

double number(const YAML::Node& node, const std::string& field, const char* what) {
  double value = 0.0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value)) fail(node, field, std::string("must be a number") + what);
  if (!std::isfinite(value)) fail(node, field, "must be finite, is " + node.Scalar());
  if (std::abs(value) > kFarthest) fail(node, field, "must be within 10000 m, is " + node.Scalar());
  return value;
}

std::string text_of_scene(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) throw InvalidScene("", "the scene file cannot be read");
  return text.str();
}

}  // namespace foothold::geometry
