// A terrain as the file that it is read from.
#include "geometry/scene_text.hpp"
#include "terrain/terrain.hpp"

namespace foothold::terrain {

std::string to_yaml(const Terrain& terrain) {
  std::string out = "kind: terrain\n";
  if (!terrain.description.empty()) out += "description: " + geometry::quoted(terrain.description) + "\n";
  out += "vertices:\n";
  for (const Vector3d& v : terrain.vertices) out += "  - " + geometry::triple_text(v) + "\n";
  out += "triangles:\n";
  for (const auto& [a, b, c] : terrain.triangles)
    out += "  - [" + std::to_string(a) + ", " + std::to_string(b) + ", " + std::to_string(c) + "]\n";
  return out;
}

}  // namespace foothold::terrain
