// A layout as the file that it is read from.
#include <charconv>

#include "truss/layout.hpp"

namespace foothold::truss {
namespace {

// The shortest digits that read back as the same number, whatever the locale.
std::string number(double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
  return {digits, end};
}

std::string triple(const Vector3d& v) { return "[" + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + "]"; }

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

}  // namespace

std::string to_yaml(const Layout& layout) {
  std::string out = "kind: truss\n";
  if (!layout.description.empty()) out += "description: " + quoted(layout.description) + "\n";
  if (!layout.beams.empty()) out += "beams:\n";
  for (const Beam& beam : layout.beams)
    out += "  - {name: " + quoted(beam.name) + ", from: " + triple(beam.from) + ", to: " + triple(beam.to) +
           ", profile: {width: " + number(beam.width) + ", height: " + number(beam.height) + "}, up: " + triple(beam.up) + "}\n";
  if (!layout.plates.empty()) out += "faces:\n";
  for (const Plate& plate : layout.plates) {
    out += "  - {name: " + quoted(plate.name) + ", polygon: [";
    for (std::size_t k = 0; k < plate.polygon.size(); ++k) out += (k > 0 ? ", " : "") + triple(plate.polygon[k]);
    out += "], normal: " + triple(plate.normal) + "}\n";
  }
  return out;
}

}  // namespace foothold::truss
