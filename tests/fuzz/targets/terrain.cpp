// Scenes of triangles, slopes among them: what was read is written and read again as the same.
#include "terrain/terrain.hpp"
#include "../fuzzing.hpp"
#include "foothold/errors.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  terrain::Terrain read;
  try {
    read = terrain::parse_terrain(fuzz::text_of(data, size));
  } catch (const InvalidScene&) {
    return 0;
  }
  const terrain::Terrain again = terrain::parse_terrain(terrain::to_yaml(read));
  fuzz::demand(again.vertices == read.vertices && again.triangles == read.triangles, "a terrain reads back as the same");
  return 0;
}
