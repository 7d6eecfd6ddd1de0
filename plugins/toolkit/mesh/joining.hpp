// Inside of the mesh library: triangles with corners of their own to triangles that share them.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>

#include "mesh/triangle_mesh.hpp"

namespace foothold::mesh {

inline std::string triangle(std::size_t k) { return "triangles[" + std::to_string(k) + "]"; }

// Finds vertices again that were there before.
class Welder {
 public:
  explicit Welder(std::vector<Vector3d>& vertices) : vertices_(vertices) {}
  int weld(const Vector3d& v);

 private:
  std::vector<Vector3d>& vertices_;
  std::unordered_multimap<std::uint64_t, int> cells_;
};

// Throws InvalidScene where triangle `k` is degenerate.
void demand_height(const TriangleMesh& mesh, std::size_t k);
// Fills `neighbours`. Throws InvalidScene.
void find_neighbours(TriangleMesh& mesh);

}  // namespace foothold::mesh
