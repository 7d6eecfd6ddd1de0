// Obstacles for tests.
#pragma once

#include <random>
#include <vector>

#include "surroundings.hpp"

namespace foothold::xrobin {

// Convex obstacles of up to `size` m in a ring round the origin between two radii.
inline std::vector<geometry::Obstacle> random_obstacles(std::mt19937_64& random, int count, double inner, double outer,
                                                        double size) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<geometry::Obstacle> out;
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * unit(random);
    const double r = inner + (outer - inner) * unit(random);
    const double turn = unit(random);
    geometry::Polygon polygon;
    const int corners = 3 + static_cast<int>(random() % 4);
    for (int i = 0; i < corners; ++i) {
      const double a = 2.0 * std::numbers::pi * (turn + static_cast<double>(i) / corners);
      polygon.emplace_back(r * std::cos(angle) + 0.5 * size * std::cos(a), r * std::sin(angle) + 0.5 * size * std::sin(a));
    }
    out.push_back({"obstacle " + std::to_string(k), polygon});
  }
  return out;
}

}  // namespace foothold::xrobin
