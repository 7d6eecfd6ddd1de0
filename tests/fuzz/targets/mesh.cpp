// Mesh files, as terrain and as truss. The first octet chooses the format.
#include "../fuzzing.hpp"
#include "foothold/errors.hpp"
#include "terrain/terrain.hpp"
#include "truss/truss.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  constexpr const char* kFormats[] = {"mesh.stl", "mesh.obj", "mesh.ply"};
  if (size == 0) return 0;
  const std::string file = fuzz::as_file(kFormats[data[0] % std::size(kFormats)], fuzz::octets_of(data + 1, size - 1));
  try {
    const terrain::Terrain terrain = terrain::read_terrain(file);
    fuzz::demand(terrain.size() > 0, "a terrain has triangles");
  } catch (const InvalidScene&) {
  }
  try {
    fuzz::demand(!truss::read_mesh(file).faces.empty(), "a truss has faces");
  } catch (const InvalidScene&) {
  }
  return 0;
}
