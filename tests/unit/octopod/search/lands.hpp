// Grounds for the tests: the paper's terrain and generated ones, with their surfaces kept alive.
#pragma once

#include <cstdlib>
#include <memory>

#include "octopod/search/route.hpp"
#include "robot.hpp"
#include "terrain/generate.hpp"

namespace foothold::octopod {

inline bool long_tests() { return std::getenv("FOOTHOLD_LONG") != nullptr; }

struct Land {
  explicit Land(terrain::Terrain of) : terrain(std::move(of)), surface(terrain) {}
  terrain::Terrain terrain;
  terrain::Surface surface;
};

inline std::shared_ptr<const terrain::Surface> surface_of(terrain::Terrain terrain) {
  const auto land = std::make_shared<Land>(std::move(terrain));
  return {land, &land->surface};
}

inline Ground ground_of(terrain::Terrain terrain, const GroundOptions& options = {}) {
  return Ground(octopod(), surface_of(std::move(terrain)), options);
}

// The points of the paper, section 6, m.
inline const Vector3d kO(0.0, 0.0, -0.5), kA(0.0, 0.75, -0.2), kB(-1.0, -0.4, 0.2);

// A state of the node in which the robot is stable, or any if there is none.
inline State stable_state(const Ground& ground, int node) {
  for (State state = kOrientations * node; state < kOrientations * (node + 1); ++state)
    if (ground.stable(state)) return state;
  return kOrientations * node;
}

inline State state_at(const Ground& ground, const Vector3d& point) { return stable_state(ground, ground.nearest_node(point)); }

}  // namespace foothold::octopod
