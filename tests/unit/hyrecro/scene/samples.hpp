// Models, random faces and random numbers that the scene's tests share.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "foothold/robot_file.hpp"
#include "hyrecro/scene/transitions.hpp"
#include "truss/layout.hpp"

namespace foothold::hyrecro {

inline Model shipped_model() { return Model::from_model(load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml")); }

inline truss::Truss shipped_scene(const char* name) {
  return truss::read_truss(std::string(FOOTHOLD_CONFIG_DIR "/scenes/") + name + ".yaml");
}

inline double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

// A star round the origin: simple, counter-clockwise, with reflex corners; radii from `least` to `most`, m.
inline Polygon star(std::mt19937_64& random, double least, double most) {
  Polygon out;
  const int corners = 3 + static_cast<int>(random() % 9);
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + uniform(random, 0.0, 0.8)) / corners;
    out.push_back(uniform(random, least, most) * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return out;
}

// A star with a smaller one cut out of it in most cases.
inline truss::Face random_face(std::mt19937_64& random) {
  truss::Face face;
  face.frame = Isometry3d::Identity();
  face.outline = star(random, 0.4, 1.0);
  while (geometry::first_crossing(face.outline)) face.outline = star(random, 0.4, 1.0);
  if (random() % 3 == 0) return face;
  Polygon hole = star(random, 0.02, 0.1);
  for (std::size_t k = 0; k < face.outline.size(); ++k) {
    const Vector2d &a = face.outline[k], &b = face.outline[(k + 1) % face.outline.size()];
    if (geometry::distance(hole, a, b) == 0.0) return face;
  }
  if (!geometry::contains(std::span<const Vector2d>(face.outline), hole[0]) || geometry::first_crossing(hole)) return face;
  std::reverse(hole.begin(), hole.end());
  face.holes.push_back(hole);
  return face;
}

}  // namespace foothold::hyrecro
