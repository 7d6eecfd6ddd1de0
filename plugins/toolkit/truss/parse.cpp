// YAML to a layout that can be relied on.
#include <cmath>
#include <set>

#include "geometry/scene_yaml.hpp"
#include "truss/layout.hpp"

namespace foothold::truss {
namespace {

using geometry::at;
using geometry::demand_keys;
using geometry::demand_kind;
using geometry::fail;
using geometry::number;
using geometry::word;

constexpr double kShortest = 1e-6;           // m, of beams and profiles
constexpr double kTolerance = 1e-6;          // m, rad: of planes and unit vectors
constexpr double kLeastArea = 1e-12;         // m^2: less is a line drawn twice
constexpr std::size_t kMostVertices = 1000;  // of a face: its checks and pieces take the square of it and more
constexpr double kLeastSideways = 1e-3;      // of `up`: sine of its angle to the beam

YAML::Node demand(const YAML::Node& node, const std::string& field, const char* key) {
  YAML::Node value = node[key];
  if (!value) fail(node, field + "." + key, "is missing");
  return value;
}

Vector3d triple(const YAML::Node& node, const std::string& field, const char* what) {
  if (!node.IsSequence() || node.size() != 3) fail(node, field, std::string("must be [x, y, z]") + what);
  return {number(node[0], at(field, 0), what), number(node[1], at(field, 1), what), number(node[2], at(field, 2), what)};
}

double edge(const YAML::Node& node, const std::string& field) {
  const double value = number(node, field, " in m");
  if (value < kShortest) fail(node, field, "must be 1e-6 m at least, is " + node.Scalar());
  return value;
}

// Names of faces are made from it with "/" and ".", so it holds neither.
std::string name(const YAML::Node& node, const std::string& field, std::set<std::string>& taken) {
  const YAML::Node given = demand(node, field, "name");
  std::string out = word(given, field + ".name");
  if (out.empty()) fail(given, field + ".name", "must not be empty");
  if (out.find_first_of("/.") != std::string::npos)
    fail(given, field + ".name", "must not hold '/' or '.', which part the names of faces, is '" + out + "'");
  if (!taken.insert(out).second) fail(given, field + ".name", "'" + out + "' is given twice");
  return out;
}

Beam beam(const YAML::Node& node, const std::string& field, std::set<std::string>& taken) {
  demand_keys(node, field, {"name", "from", "to", "profile", "up"});
  Beam out;
  out.name = name(node, field, taken);
  out.from = triple(demand(node, field, "from"), field + ".from", " in m");
  out.to = triple(demand(node, field, "to"), field + ".to", " in m");
  if ((out.to - out.from).norm() < kShortest) fail(node["to"], field + ".to", "is where the beam begins: a beam needs a length");
  const YAML::Node profile = demand(node, field, "profile");
  demand_keys(profile, field + ".profile", {"width", "height"});
  out.width = edge(demand(profile, field + ".profile", "width"), field + ".profile.width");
  out.height = edge(demand(profile, field + ".profile", "height"), field + ".profile.height");
  out.up = default_up(out.to - out.from);
  if (const YAML::Node up = node["up"]) {
    out.up = triple(up, field + ".up", "");
    if (out.up.norm() < kShortest) fail(up, field + ".up", "must not be zero");
    if ((out.to - out.from).normalized().cross(out.up.normalized()).norm() < kLeastSideways)
      fail(up, field + ".up", "must not point along the beam");
  }
  return out;
}

Plate plate(const YAML::Node& node, const std::string& field, std::set<std::string>& taken) {
  demand_keys(node, field, {"name", "polygon", "normal"});
  Plate out;
  out.name = name(node, field, taken);
  const YAML::Node list = demand(node, field, "polygon");
  const std::string path = field + ".polygon";
  if (!list.IsSequence()) fail(list, path, "must be a list of vertices [x, y, z]");
  if (list.size() < 3) fail(list, path, "must have three vertices at least, has " + std::to_string(list.size()));
  if (list.size() > kMostVertices) fail(list, path, "must have 1000 vertices at most, has " + std::to_string(list.size()));
  for (std::size_t k = 0; k < list.size(); ++k) {
    out.polygon.push_back(triple(list[k], at(path, k), " in m"));
    if (k > 0 && out.polygon[k] == out.polygon[k - 1]) fail(list[k], at(path, k), "is the same as the vertex before it");
  }
  if (out.polygon.front() == out.polygon.back())
    fail(list, at(path, list.size() - 1), "repeats the first vertex; polygons close by themselves");
  Vector3d area = Vector3d::Zero(), centre = Vector3d::Zero();
  for (std::size_t k = 0; k < list.size(); ++k) {
    centre += out.polygon[k] / static_cast<double>(list.size());
    if (k > 0 && k + 1 < list.size()) area += 0.5 * (out.polygon[k] - out.polygon[0]).cross(out.polygon[k + 1] - out.polygon[0]);
  }
  if (area.norm() < kLeastArea) fail(list, path, "has no area");
  for (std::size_t k = 0; k < list.size(); ++k)
    if (const double off = std::abs((out.polygon[k] - centre).dot(area.normalized())); off > kTolerance)
      fail(list[k], at(path, k), "is " + std::to_string(off) + " m off the others' plane; faces are planar within 1e-6 m");
  const YAML::Node normal = demand(node, field, "normal");
  out.normal = triple(normal, field + ".normal", "");
  if (std::abs(out.normal.norm() - 1.0) > kTolerance)
    fail(normal, field + ".normal", "must be of length 1, is " + std::to_string(out.normal.norm()));
  if (out.normal.cross(area.normalized()).norm() > kTolerance)
    fail(normal, field + ".normal", "is not perpendicular to the polygon");
  const Vector3d x = axis_in(area.normalized()), y = area.normalized().cross(x);
  Polygon flat;
  for (const Vector3d& v : out.polygon) flat.emplace_back((v - centre).dot(x), (v - centre).dot(y));
  if (const auto crossing = geometry::first_crossing(flat))
    fail(list[*crossing], at(path, *crossing), "begins an edge that crosses or touches another one");
  return out;
}

template <class Read>
void each(const YAML::Node& root, const char* key, Read&& read) {
  const YAML::Node list = root[key];
  if (!list) return;
  if (!list.IsSequence()) fail(list, key, "must be a list");
  for (std::size_t k = 0; k < list.size(); ++k) read(list[k], at(key, k));
}

Layout layout(const YAML::Node& root) {
  demand_keys(root, "", {"kind", "description", "beams", "faces"});
  demand_kind(root, "truss");
  Layout out;
  if (root["description"]) out.description = word(root["description"], "description");
  std::set<std::string> taken;
  each(root, "beams", [&](const YAML::Node& node, const std::string& field) { out.beams.push_back(beam(node, field, taken)); });
  each(root, "faces", [&](const YAML::Node& node, const std::string& field) { out.plates.push_back(plate(node, field, taken)); });
  if (out.beams.empty() && out.plates.empty()) fail(root, "beams", "is missing or empty, and so is faces: nothing to climb");
  return out;
}

}  // namespace

Layout parse_layout(const std::string& text) { return geometry::read_yaml(text, layout); }

Truss parse_truss(const std::string& text) { return build(parse_layout(text)); }

Truss read_truss(const std::string& path) { return parse_truss(geometry::text_of_scene(path)); }

}  // namespace foothold::truss
