// Mesh files, as terrain and as truss. The first octet chooses the format.
#include "../fuzzing.hpp"
#include "foothold/errors.hpp"
#include "terrain/terrain.hpp"
#include "truss/merge_coplanar.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  constexpr const char* kFormats[] = {"stl", "obj", "ply"};
  if (size == 0) return 0;
  mesh::TriangleMesh read;
  try {
    read = mesh::parse_triangles(fuzz::text_of(data + 1, size - 1), kFormats[data[0] % std::size(kFormats)]);
  } catch (const InvalidScene&) {
    return 0;
  }
  fuzz::demand(!read.triangles.empty() && read.neighbours.size() == read.triangles.size(), "a mesh has triangles");
  try {
    fuzz::demand(terrain::make_terrain(read).size() > 0, "a terrain has triangles");
  } catch (const InvalidScene&) {
  }
  fuzz::demand(!truss::merge_coplanar(read).faces.empty(), "a truss has faces");
  return 0;
}
