// A mesh to a terrain: which way is out, what is ground.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "foothold/errors.hpp"
#include "terrain/adjacency.hpp"
#include "terrain/terrain.hpp"

namespace foothold::terrain {
namespace {

using mesh::TriangleMesh;

std::string metres(double length) {
  char out[40];
  std::snprintf(out, sizeof(out), "%.3g m", length);
  return out;
}

void demand_extent(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d bounds;
  for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
    if (!mesh.vertices[k].allFinite()) throw InvalidScene("vertices[" + std::to_string(k) + "]", "is not finite");
    bounds.extend(mesh.vertices[k]);
  }
  const double longest = bounds.sizes().maxCoeff();
  if (longest > kGreatestExtent)
    throw InvalidScene("vertices", "the terrain is " + metres(longest) +
                                       " long, more than 1000 m: are its coordinates in mm? They must be in m; nothing is scaled");
  if (longest < kLeastExtent)
    throw InvalidScene("vertices", "the terrain is " + metres(longest) +
                                       " long, less than 0.01 m: are its coordinates in km? They must be in m; nothing is scaled");
}

const Vector3d& corner(const TriangleMesh& mesh, std::size_t triangle, std::size_t k) {
  return mesh.vertices[static_cast<std::size_t>(mesh.triangles[triangle][k])];
}

// Twice the area, along the outer normal.
Vector3d area_of(const TriangleMesh& mesh, std::size_t t) {
  const Vector3d& a = corner(mesh, t, 0);
  return (corner(mesh, t, 1) - a).cross(corner(mesh, t, 2) - a);
}

// Each connected part so that its outer side is out, as terrain.hpp says.
void turn_outwards(TriangleMesh& mesh) {
  std::vector<bool> seen(mesh.triangles.size(), false);
  std::vector<std::size_t> part;
  for (std::size_t first = 0; first < mesh.triangles.size(); ++first) {
    if (seen[first]) continue;
    part.assign(1, first);
    seen[first] = true;
    bool closed = true;
    double area = 0.0, volume = 0.0;
    const Vector3d origin = corner(mesh, first, 0);  // near the part, or the volume is lost to rounding
    for (std::size_t k = 0; k < part.size(); ++k) {
      const std::size_t t = part[k];
      area += area_of(mesh, t).z();
      volume += area_of(mesh, t).dot(corner(mesh, t, 0) - origin);
      for (const int n : mesh.neighbours[t]) {
        closed = closed && n >= 0;
        if (n < 0 || seen[static_cast<std::size_t>(n)]) continue;
        seen[static_cast<std::size_t>(n)] = true;
        part.push_back(static_cast<std::size_t>(n));
      }
    }
    if ((closed ? volume : area) >= 0.0) continue;
    for (const std::size_t t : part) {
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
      std::swap(mesh.neighbours[t][0], mesh.neighbours[t][2]);
    }
  }
}

}  // namespace

void find_normals(Terrain& terrain) {
  terrain.normals.reserve(terrain.size());
  terrain.centroids.reserve(terrain.size());
  for (int t = 0; t < static_cast<int>(terrain.size()); ++t) {
    const Vector3d &a = terrain.corner(t, 0), &b = terrain.corner(t, 1), &c = terrain.corner(t, 2);
    terrain.normals.push_back((b - a).cross(c - a).normalized());
    terrain.centroids.push_back((a + b + c) / 3.0);
  }
}

Terrain make_terrain(TriangleMesh mesh, std::string description) {
  if (mesh.triangles.empty()) throw InvalidScene("triangles", "there are none");
  demand_extent(mesh);
  turn_outwards(mesh);
  Terrain out;
  out.description = std::move(description);
  out.vertices = std::move(mesh.vertices);
  out.triangles = std::move(mesh.triangles);
  find_normals(out);
  for (std::size_t t = 0; t < out.size(); ++t) {
    out.ground.push_back(out.normals[t].z() > kLeastUp ? 1 : 0);
    out.origins.push_back(static_cast<int>(t));
  }
  if (std::none_of(out.ground.begin(), out.ground.end(), [](std::uint8_t up) { return up != 0; }))
    throw InvalidScene("triangles", "none faces up (z): there is no ground to stand on");
  find_adjacent(out, {});
  return out;
}

double circumradius(const Terrain& terrain, int triangle) {
  const Vector3d a = terrain.corner(triangle, 1) - terrain.corner(triangle, 0),
                 b = terrain.corner(triangle, 2) - terrain.corner(triangle, 0);
  return a.norm() * b.norm() * (a - b).norm() / (2.0 * a.cross(b).norm());
}

double slope(const Terrain& terrain, int triangle) {
  const Vector3d& normal = terrain.normals[static_cast<std::size_t>(triangle)];
  return std::atan2(normal.head<2>().norm(), normal.z());
}

}  // namespace foothold::terrain
