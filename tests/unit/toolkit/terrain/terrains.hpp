// Terrains for tests, and questions answered without trees.
#pragma once

#include <random>

#include "terrain/generate.hpp"
#include "terrain/surface.hpp"

namespace foothold::terrain {

inline double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

inline double area(const Terrain& terrain, int t) {
  return 0.5 * (terrain.corner(t, 1) - terrain.corner(t, 0)).cross(terrain.corner(t, 2) - terrain.corner(t, 0)).norm();
}

inline std::vector<Terrain> some_terrains() {
  Options options;
  options.seed = 5;
  options.size = 3.0;
  std::vector<Terrain> out{ramps()};
  for (const Family family : {Family::kBoulders, Family::kStairs, Family::kDitch}) out.push_back(generate(family, options));
  return out;
}

// In the terrain's bounds and half a metre round them.
inline Vector3d point_about(const Terrain& terrain, std::mt19937_64& random) {
  Eigen::AlignedBox3d bounds;
  for (const Vector3d& v : terrain.vertices) bounds.extend(v);
  Vector3d out;
  for (Eigen::Index k = 0; k < 3; ++k) out[k] = uniform(random, bounds.min()[k] - 0.5, bounds.max()[k] + 0.5);
  return out;
}

}  // namespace foothold::terrain
