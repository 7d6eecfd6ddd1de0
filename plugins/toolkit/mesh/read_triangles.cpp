// Mesh files to triangles that can be relied on.
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <unordered_map>

#include "foothold/errors.hpp"
#include "geometry/axis.hpp"
#include "geometry/triangulation.hpp"
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

// The library never comes back from a PLY file that ends too early or promises more than it holds.
void demand_whole_ply(const std::string& text) {
  std::istringstream lines(text);
  std::size_t promised = 0;
  bool ascii = false, whole = false;
  for (std::string line; !whole && std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first, second;
    words >> first >> second;
    std::size_t count = 0;
    if (first == "format") ascii = second == "ascii";
    if (first == "element" && (!(words >> count) || count > text.size()))
      throw InvalidScene("", "the mesh promises more of '" + second + "' than the file can hold");
    promised += count;
    whole = first == "end_header";
  }
  if (!whole) throw InvalidScene("", "the mesh's header has no end");
  std::size_t there = 0;
  if (ascii)
    for (std::string line; std::getline(lines, line);) there += line.find_first_not_of(" \t\r") != std::string::npos ? 1 : 0;
  else
    there = lines.good() ? text.size() - static_cast<std::size_t>(lines.tellg()) : 0;
  if (there < promised)
    throw InvalidScene("", "the mesh ends early: " + std::to_string(promised) + " elements are promised, there is room for " +
                               std::to_string(there));
}

std::string ending(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  std::string out = dot == std::string::npos || path[dot] == '/' ? "" : path.substr(dot + 1);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

void demand_format(const std::string& format) {
  if (format != "stl" && format != "obj" && format != "ply")
    throw InvalidScene("", "a mesh is a file .stl, .obj or .ply, is '" + format + "'");
}

// To make an importer takes longer than to read a small file: each thread keeps one, but no scene in it.
class Reading {
 public:
  // From memory, so that no other file is opened, whatever this one names.
  Reading(const std::string& octets, const std::string& format)
      : scene_(importer().ReadFileFromMemory(octets.data(), octets.size(), 0, format.c_str())) {
    if (scene_ == nullptr) throw InvalidScene("", std::string("the mesh cannot be read: ") + importer().GetErrorString());
  }
  ~Reading() { importer().FreeScene(); }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  const aiScene& scene() const { return *scene_; }

 private:
  static Assimp::Importer& importer() {
    thread_local Assimp::Importer kept;
    return kept;
  }
  const aiScene* scene_;
};

}  // namespace

TriangleMesh read_triangles(const std::string& path) {
  const std::string format = ending(path);
  demand_format(format);
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  if (!file || !(bytes << file.rdbuf())) throw InvalidScene("", "the scene file cannot be read");
  return parse_triangles(std::move(bytes).str(), format);
}

TriangleMesh parse_triangles(const std::string& octets, const std::string& format) {
  demand_format(format);
  if (format == "ply") demand_whole_ply(octets);
  const Reading reading(octets, format);
  const aiScene& scene = reading.scene();
  TriangleMesh mesh;
  Welder welder(mesh.vertices);
  std::vector<int> corners;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[m];
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      const std::string here = triangle(mesh.triangles.size());
      if (face.mNumIndices < 3) throw InvalidScene(here, "is a point or a line, no triangle");
      corners.clear();
      for (unsigned c = 0; c < face.mNumIndices; ++c) {
        if (face.mIndices[c] >= part.mNumVertices) throw InvalidScene(here, "names a vertex that is not there");
        const aiVector3D& at = part.mVertices[face.mIndices[c]];
        const Vector3d v(at.x, at.y, at.z);
        if (!v.allFinite() || v.cwiseAbs().maxCoeff() > kFarthest)
          throw InvalidScene(here, "has a corner that is not finite or beyond 10000 m");
        corners.push_back(welder.weld(v));
      }
      add_triangles(mesh, corners);
    }
  }
  if (mesh.triangles.empty()) throw InvalidScene("triangles", "there are none");
  find_neighbours(mesh);
  return mesh;
}

}  // namespace foothold::mesh
