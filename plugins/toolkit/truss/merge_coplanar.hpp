// Triangles to faces.
#pragma once

#include "mesh/triangle_mesh.hpp"
#include "truss/truss.hpp"

namespace foothold::truss {

// Coplanar triangles (1e-6 m off the plane of the greatest of them) that share edges become one face; its convex pieces are solids.
Truss merge_coplanar(const mesh::TriangleMesh& mesh);

}  // namespace foothold::truss
