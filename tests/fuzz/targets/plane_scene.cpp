// Scenes of obstacles on flat ground.
#include "geometry/plane_scene.hpp"
#include "../fuzzing.hpp"
#include "foothold/errors.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  try {
    for (const auto& obstacle : geometry::parse_plane_scene(fuzz::text_of(data, size)).obstacles)
      fuzz::demand(obstacle.polygon.size() >= 3 && geometry::signed_area(obstacle.polygon) > 0.0, "an obstacle has an area");
  } catch (const InvalidScene&) {
  }
  return 0;
}
