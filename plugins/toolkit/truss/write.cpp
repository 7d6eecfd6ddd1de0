// A layout as the file that it is read from.
#include "geometry/scene_text.hpp"
#include "truss/layout.hpp"

namespace foothold::truss {

using geometry::number_text;
using geometry::quoted;
using geometry::triple_text;

std::string to_yaml(const Layout& layout) {
  std::string out = "kind: truss\n";
  if (!layout.description.empty()) out += "description: " + quoted(layout.description) + "\n";
  if (!layout.beams.empty()) out += "beams:\n";
  for (const Beam& beam : layout.beams)
    out += "  - {name: " + quoted(beam.name) + ", from: " + triple_text(beam.from) + ", to: " + triple_text(beam.to) +
           ", profile: {width: " + number_text(beam.width) + ", height: " + number_text(beam.height) +
           "}, up: " + triple_text(beam.up) + "}\n";
  if (!layout.plates.empty()) out += "faces:\n";
  for (const Plate& plate : layout.plates) {
    out += "  - {name: " + quoted(plate.name) + ", polygon: [";
    for (std::size_t k = 0; k < plate.polygon.size(); ++k) out += (k > 0 ? ", " : "") + triple_text(plate.polygon[k]);
    out += "], normal: " + triple_text(plate.normal) + "}\n";
  }
  return out;
}

}  // namespace foothold::truss
