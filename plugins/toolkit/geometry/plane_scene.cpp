// YAML to polygons that can be relied on.
#include "geometry/plane_scene.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <set>
#include <sstream>

#include "foothold/errors.hpp"

namespace foothold::geometry {
namespace {

constexpr double kLeastArea = 1e-12;  // m^2: less is a line drawn twice
constexpr double kFarthest = 1e4;     // m: beyond that millimetres are lost to rounding

[[noreturn]] void fail(const YAML::Node& node, const std::string& field, const std::string& reason) {
  throw InvalidScene(field, "line " + std::to_string(node.Mark().line + 1) + ": " + reason);
}

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

std::string word(const YAML::Node& node, const std::string& field) {
  if (!node.IsScalar()) fail(node, field, "must be a word");
  return node.Scalar();
}

double coordinate(const YAML::Node& node, const std::string& field) {
  double value = 0.0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value)) fail(node, field, "must be a number in m");
  if (!std::isfinite(value)) fail(node, field, "must be finite, is " + node.Scalar());
  if (std::abs(value) > kFarthest) fail(node, field, "must be within 10000 m, is " + node.Scalar());
  return value;
}

Polygon polygon(const YAML::Node& node, const std::string& field) {
  if (!node.IsSequence()) fail(node, field, "must be a list of vertices [x, y]");
  if (node.size() < 3) fail(node, field, "must have three vertices at least, has " + std::to_string(node.size()));
  const auto vertex = [&](std::size_t k) { return field + "[" + std::to_string(k) + "]"; };
  Polygon out;
  for (std::size_t k = 0; k < node.size(); ++k) {
    if (!node[k].IsSequence() || node[k].size() != 2) fail(node[k], vertex(k), "must be [x, y] in m");
    out.emplace_back(coordinate(node[k][0], vertex(k) + "[0]"), coordinate(node[k][1], vertex(k) + "[1]"));
    if (k > 0 && out[k] == out[k - 1]) fail(node[k], vertex(k), "is the same as the vertex before it");
  }
  if (out.front() == out.back()) fail(node, vertex(out.size() - 1), "repeats the first vertex; polygons close by themselves");
  const double area = signed_area(out);
  if (std::abs(area) < kLeastArea) fail(node, field, "has no area");
  if (const auto at = first_crossing(out)) fail(node[*at], vertex(*at), "begins an edge that crosses or touches another one");
  if (area < 0.0) std::reverse(out.begin(), out.end());
  return out;
}

PlaneScene scene(const YAML::Node& root) {
  demand_keys(root, "", {"kind", "description", "obstacles"});
  if (!root["kind"]) fail(root, "kind", "is missing; this reader takes 'plane'");
  if (const std::string kind = word(root["kind"], "kind"); kind != "plane")
    fail(root["kind"], "kind", "must be plane, is '" + kind + "'");
  PlaneScene out;
  if (root["description"]) out.description = word(root["description"], "description");
  const YAML::Node list = root["obstacles"];
  if (!list) fail(root, "obstacles", "is missing; an empty list is []");
  if (!list.IsSequence()) fail(list, "obstacles", "must be a list");
  std::set<std::string> names;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::string field = "obstacles[" + std::to_string(k) + "]";
    demand_keys(list[k], field, {"name", "polygon"});
    if (!list[k]["name"]) fail(list[k], field + ".name", "is missing");
    if (!list[k]["polygon"]) fail(list[k], field + ".polygon", "is missing");
    Obstacle obstacle{word(list[k]["name"], field + ".name"), polygon(list[k]["polygon"], field + ".polygon")};
    if (obstacle.name.empty()) fail(list[k]["name"], field + ".name", "must not be empty");
    if (!names.insert(obstacle.name).second) fail(list[k]["name"], field + ".name", "'" + obstacle.name + "' is given twice");
    out.obstacles.push_back(std::move(obstacle));
  }
  return out;
}

}  // namespace

PlaneScene parse_plane_scene(const std::string& text) {
  try {
    return scene(YAML::Load(text));
  } catch (const YAML::Exception& fault) {
    throw InvalidScene("", "line " + std::to_string(fault.mark.line + 1) + ": " + fault.msg);
  }
}

PlaneScene read_plane_scene(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) throw InvalidScene("", "the scene file cannot be read");
  return parse_plane_scene(text.str());
}

}  // namespace foothold::geometry
