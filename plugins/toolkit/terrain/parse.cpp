// YAML or a mesh file to a terrain.
#include "geometry/scene_yaml.hpp"
#include "terrain/terrain.hpp"

namespace foothold::terrain {
namespace {

using geometry::at;
using geometry::demand_keys;
using geometry::demand_kind;
using geometry::fail;
using geometry::number;
using geometry::word;

YAML::Node demand_list(const YAML::Node& root, const char* key, std::size_t most) {
  const YAML::Node list = root[key];
  if (!list) fail(root, key, "is missing");
  if (!list.IsSequence()) fail(list, key, "must be a list");
  if (list.size() == 0) fail(list, key, "is empty");
  if (list.size() > most) fail(list, key, "has more than " + std::to_string(most) + " entries");
  return list;
}

int index(const YAML::Node& node, const std::string& field, std::size_t count) {
  int value = -1;
  if (!node.IsScalar() || !YAML::convert<int>::decode(node, value)) fail(node, field, "must be the index of a vertex");
  if (value < 0 || static_cast<std::size_t>(value) >= count)
    fail(node, field, "must be the index of one of the " + std::to_string(count) + " vertices, is " + node.Scalar());
  return value;
}

Terrain terrain(const YAML::Node& root) {
  demand_keys(root, "", {"kind", "description", "vertices", "triangles"});
  demand_kind(root, "terrain");
  const std::string description = root["description"] ? word(root["description"], "description") : "";
  std::vector<Vector3d> vertices;
  const YAML::Node points = demand_list(root, "vertices", 3 * mesh::kMostTriangles);
  std::size_t k = 0;
  for (const auto& node : points) {
    const std::string field = at("vertices", k++);
    if (!node.IsSequence() || node.size() != 3) fail(node, field, "must be [x, y, z] in m");
    vertices.emplace_back(number(node[0], at(field, 0), " in m"), number(node[1], at(field, 1), " in m"),
                          number(node[2], at(field, 2), " in m"));
  }
  std::vector<std::array<int, 3>> triangles;
  std::vector<YAML::Node> lines;
  const YAML::Node faces = demand_list(root, "triangles", mesh::kMostTriangles);
  for (const auto& node : faces) {
    const std::string field = at("triangles", triangles.size());
    if (!node.IsSequence() || node.size() != 3) fail(node, field, "must be the indices of three vertices");
    triangles.push_back({index(node[0], at(field, 0), vertices.size()), index(node[1], at(field, 1), vertices.size()),
                         index(node[2], at(field, 2), vertices.size())});
    lines.push_back(node);
  }
  try {
    return make_terrain(mesh::joined(vertices, triangles), description);
  } catch (const InvalidScene& fault) {  // what the mesh refuses knows no line
    for (std::size_t t = 0; t < lines.size(); ++t)
      if (fault.field() == at("triangles", t)) fail(lines[t], fault.field(), fault.what());
    fail(fault.field() == "vertices" ? points : faces, fault.field(), fault.what());
  }
}

}  // namespace

Terrain parse_terrain(const std::string& text) { return geometry::read_yaml(text, terrain); }

Terrain read_terrain(const std::string& path) {
  if (path.ends_with(".yaml")) return parse_terrain(geometry::text_of_scene(path));
  return make_terrain(mesh::read_triangles(path));
}

}  // namespace foothold::terrain
