// Scenes of beams and faces, built whole.
#include "truss/truss.hpp"
#include "../fuzzing.hpp"
#include "foothold/errors.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  try {
    for (const truss::Face& face : truss::parse_truss(fuzz::text_of(data, size)).faces)
      fuzz::demand(face.outline.size() >= 3 && face.frame.matrix().allFinite(), "a face is a polygon in a plane");
  } catch (const InvalidScene&) {
  }
  return 0;
}
