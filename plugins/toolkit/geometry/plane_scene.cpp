// YAML to polygons that can be relied on.
#include "geometry/plane_scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/scene_yaml.hpp"

namespace foothold::geometry {
namespace {

constexpr double kLeastArea = 1e-12;  // m^2: less is a line drawn twice

Polygon polygon(const YAML::Node& node, const std::string& field) {
  if (!node.IsSequence()) fail(node, field, "must be a list of vertices [x, y]");
  if (node.size() < 3) fail(node, field, "must have three vertices at least, has " + std::to_string(node.size()));
  const auto vertex = [&](std::size_t k) { return at(field, k); };
  Polygon out;
  for (std::size_t k = 0; k < node.size(); ++k) {
    if (!node[k].IsSequence() || node[k].size() != 2) fail(node[k], vertex(k), "must be [x, y] in m");
    out.emplace_back(number(node[k][0], at(vertex(k), 0), " in m"), number(node[k][1], at(vertex(k), 1), " in m"));
    if (k > 0 && out[k] == out[k - 1]) fail(node[k], vertex(k), "is the same as the vertex before it");
  }
  if (out.front() == out.back()) fail(node, vertex(out.size() - 1), "repeats the first vertex; polygons close by themselves");
  const double area = signed_area(out);
  if (std::abs(area) < kLeastArea) fail(node, field, "has no area");
  if (const auto crossing = first_crossing(out))
    fail(node[*crossing], vertex(*crossing), "begins an edge that crosses or touches another one");
  if (area < 0.0) std::reverse(out.begin(), out.end());
  return out;
}

PlaneScene scene(const YAML::Node& root) {
  demand_keys(root, "", {"kind", "description", "obstacles"});
  demand_kind(root, "plane");
  PlaneScene out;
  if (root["description"]) out.description = word(root["description"], "description");
  const YAML::Node list = root["obstacles"];
  if (!list) fail(root, "obstacles", "is missing; an empty list is []");
  if (!list.IsSequence()) fail(list, "obstacles", "must be a list");
  std::set<std::string> names;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::string field = at("obstacles", k);
    demand_keys(list[k], field, {"name", "polygon", "height"});
    if (!list[k]["name"]) fail(list[k], field + ".name", "is missing");
    if (!list[k]["polygon"]) fail(list[k], field + ".polygon", "is missing");
    Obstacle obstacle{word(list[k]["name"], field + ".name"), polygon(list[k]["polygon"], field + ".polygon"), {}};
    if (const YAML::Node height = list[k]["height"]) {
      obstacle.height = number(height, field + ".height", " in m");
      if (!(*obstacle.height > 0.0)) fail(height, field + ".height", "must be above 0");
    }
    if (obstacle.name.empty()) fail(list[k]["name"], field + ".name", "must not be empty");
    if (!names.insert(obstacle.name).second) fail(list[k]["name"], field + ".name", "'" + obstacle.name + "' is given twice");
    out.obstacles.push_back(std::move(obstacle));
  }
  return out;
}

}  // namespace

PlaneScene parse_plane_scene(const std::string& text) { return read_yaml(text, scene); }

PlaneScene read_plane_scene(const std::string& path) { return parse_plane_scene(text_of_scene(path)); }

}  // namespace foothold::geometry
