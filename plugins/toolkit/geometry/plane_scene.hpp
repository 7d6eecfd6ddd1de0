// Scenes for robots on flat ground: named obstacles as polygons.
//
//   kind: plane
//   description: a doorway          # for people; may be left out
//   obstacles:
//     - name: left post
//       polygon: [[0.10, 0.20], [0.15, 0.20], [0.15, 0.30], [0.10, 0.30]]   # m, x and y of each vertex in order
//       height: 0.02          # m, above the ground; left out: higher than any robot
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/polygon.hpp"

namespace foothold::geometry {

struct Obstacle {
  std::string name;
  Polygon polygon;               // simple, counter-clockwise
  std::optional<double> height;  // m, > 0; nothing: higher than any robot
};

struct PlaneScene {
  std::string description;
  std::vector<Obstacle> obstacles;
};

// Refuses unknown keys, names given twice or left out, numbers that are not finite, polygons of less than three vertices, of no
// area or that cross or touch themselves. Throws InvalidScene whose field is a path such as "obstacles[2].polygon[1]" and whose
// message begins with the line. Any thread.
PlaneScene read_plane_scene(const std::string& path);
// `text` is what the file would hold.
PlaneScene parse_plane_scene(const std::string& text);

}  // namespace foothold::geometry
