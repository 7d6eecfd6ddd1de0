// Inside of the mesh library: what the formats of mesh files hold of geometry. Colours, normals, textures and names are left out;
// geometry that is not understood is refused.
//
// All throw InvalidScene whose message begins with the line where the format has lines. Nothing of what a file promises is believed
// before it is there: memory and time are within a small multiple of the file's size. Any thread.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace foothold::mesh {

// Polygons as they stand in the file: indices may be out of range, numbers not finite, corners fewer than three.
struct Faces {
  std::vector<Vector3d> vertices;     // m
  std::vector<std::int64_t> corners;  // of all faces, one behind the other
  std::vector<std::size_t> ends;      // in `corners`, of each face
};

// STL of either kind. Binary is what has exactly the length that its number of triangles asks for.
Faces read_stl(std::string_view octets);
// Wavefront OBJ: v and f, indices from either end.
Faces read_obj(std::string_view text);
// PLY 1.0, as text and as octets of either order: the elements vertex (x, y, z) and face (vertex_indices or vertex_index).
Faces read_ply(std::string_view octets);

}  // namespace foothold::mesh
