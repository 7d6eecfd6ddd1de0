// Grounds to stand on: grids of triangles over a height function, cut finer or not.
#pragma once

#include <cmath>
#include <memory>

#include "robot.hpp"
#include "terrain/surface.hpp"

namespace foothold::octopod {

struct TestGround {
  terrain::Terrain terrain;
  terrain::Surface surface;
  explicit TestGround(terrain::Terrain made) : terrain(std::move(made)), surface(terrain) {}
  TestGround(const TestGround&) = delete;
};

// [-half, half]^2 in squares of half / cells, each cut along a diagonal that alternates; z = height(x, y).
template <class Height>
std::unique_ptr<TestGround> ground_of(double half, int cells, Height&& height) {
  std::vector<Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
  const int n = 2 * cells + 1;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double x = half * (i - cells) / cells, y = half * (j - cells) / cells;
      vertices.emplace_back(x, y, height(x, y));
    }
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i) {
      const int a = j * n + i, b = a + 1, c = b + n, d = a + n;
      if ((i + j) % 2 == 0)
        triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
      else
        triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
    }
  return std::make_unique<TestGround>(terrain::make_terrain(mesh::joined(vertices, triangles)));
}

inline std::unique_ptr<TestGround> level_ground() {
  return ground_of(1.5, 8, [](double, double) { return 0.0; });
}
// Rising by `slope` (rad) along the heading.
inline std::unique_ptr<TestGround> slope_ground(double slope, double heading = 0.0) {
  return ground_of(1.5, 8, [&](double x, double y) { return std::tan(slope) * (x * std::cos(heading) + y * std::sin(heading)); });
}
// Bumps of `size` (m) up and down, about 0.4 m apart.
inline std::unique_ptr<TestGround> bumpy_ground(double size, std::uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  return ground_of(1.5, 8, [&](double, double) { return uniform(random, -size, size); });
}

}  // namespace foothold::octopod
