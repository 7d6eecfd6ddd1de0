// Triangles with shared vertices, as mesh files hold them after all that does not matter here is left out.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "truss/truss.hpp"

namespace foothold::truss {

struct TriangleMesh {
  std::vector<Vector3d> vertices;              // m; those nearer than 1e-6 m are one
  std::vector<std::array<int, 3>> triangles;   // counter-clockwise seen from outside
  std::vector<std::array<int, 3>> neighbours;  // across the edge from corner k to k + 1; -1: none
};

// STL, OBJ or PLY by assimp; the format by the ending of the file's name. Throws InvalidScene for files that cannot be read, no or
// too many triangles (a million), numbers that are not finite or beyond 10 km, degenerate triangles (a height below 1e-6 m), edges
// of more than two triangles, neighbours whose outer sides disagree.
TriangleMesh read_triangles(const std::string& path);

// Coplanar triangles (1e-6 m off the plane of the greatest of them) that share edges become one face; its convex pieces are solids.
Truss merge_coplanar(const TriangleMesh& mesh);

}  // namespace foothold::truss
