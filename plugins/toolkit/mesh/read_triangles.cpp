// Mesh files to triangles that can be relied on.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <unordered_map>

#include "foothold/errors.hpp"
#include "geometry/axis.hpp"
#include "geometry/triangulation.hpp"
#include "mesh/formats.hpp"
#include "mesh/joining.hpp"

namespace foothold::mesh {
namespace {

constexpr double kFarthest = 1e4;           // m
constexpr double kSame = 1e-6;              // m: vertices this near are one
constexpr double kLeastHeight = 1e-6;       // m, of a triangle
constexpr std::size_t kMostCorners = 1000;  // of a polygon in the file

// A face of a file may have more corners than three.
void add_triangles(TriangleMesh& mesh, const std::vector<int>& corners) {
  const auto at = [&](std::size_t k) -> const Vector3d& { return mesh.vertices[static_cast<std::size_t>(corners[k])]; };
  std::vector<std::array<std::size_t, 3>> parts{{0, 1, 2}};
  if (corners.size() > kMostCorners) throw InvalidScene(triangle(mesh.triangles.size()), "is a polygon of more than 1000 corners");
  if (corners.size() > 3) {
    Vector3d area = Vector3d::Zero();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) area += (at(k) - at(0)).cross(at(k + 1) - at(0));
    const std::string here = triangle(mesh.triangles.size());
    if (area.norm() < kLeastHeight * kLeastHeight) throw InvalidScene(here, "is degenerate: a polygon without area");
    const Vector3d x = geometry::axis_in(area.normalized()), y = area.normalized().cross(x);
    geometry::Polygon flat;
    for (std::size_t k = 0; k < corners.size(); ++k) flat.emplace_back((at(k) - at(0)).dot(x), (at(k) - at(0)).dot(y));
    if (geometry::first_crossing(flat)) throw InvalidScene(here, "is a polygon that crosses or touches itself");
    parts = geometry::triangulated(flat);
  }
  for (const auto& part : parts) {
    if (mesh.triangles.size() == kMostTriangles) throw InvalidScene("triangles", "are more than 1000000");
    mesh.triangles.push_back({corners[part[0]], corners[part[1]], corners[part[2]]});
    demand_height(mesh, mesh.triangles.size() - 1);
  }
}

std::string ending(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  std::string out = dot == std::string::npos || path[dot] == '/' ? "" : path.substr(dot + 1);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

using Read = Faces (*)(std::string_view);

Read reader_of(const std::string& format) {
  if (format == "stl") return read_stl;
  if (format == "obj") return read_obj;
  if (format == "ply") return read_ply;
  throw InvalidScene("", "a mesh is a file .stl, .obj or .ply, is '" + format + "'");
}

}  // namespace

TriangleMesh read_triangles(const std::string& path) {
  const std::string format = ending(path);
  reader_of(format);
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  if (!file || !(bytes << file.rdbuf())) throw InvalidScene("", "the scene file cannot be read");
  return parse_triangles(std::move(bytes).str(), format);
}

TriangleMesh parse_triangles(const std::string& octets, const std::string& format) {
  const Faces faces = reader_of(format)(octets);
  TriangleMesh mesh;
  Welder welder(mesh.vertices);
  std::vector<int> corners;
  std::size_t begin = 0;
  for (const std::size_t end : faces.ends) {
    const std::string here = triangle(mesh.triangles.size());
    if (end - begin < 3) throw InvalidScene(here, "is a point or a line, no triangle");
    corners.clear();
    for (; begin < end; ++begin) {
      const std::int64_t corner = faces.corners[begin];
      if (corner < 0 || corner >= std::ssize(faces.vertices)) throw InvalidScene(here, "names a vertex that is not there");
      const Vector3d& v = faces.vertices[static_cast<std::size_t>(corner)];
      if (!v.allFinite() || v.cwiseAbs().maxCoeff() > kFarthest)
        throw InvalidScene(here, "has a corner that is not finite or beyond 10000 m");
      corners.push_back(welder.weld(v));
    }
    add_triangles(mesh, corners);
  }
  if (mesh.triangles.empty()) throw InvalidScene("triangles", "there are none");
  find_neighbours(mesh);
  return mesh;
}

}  // namespace foothold::mesh
