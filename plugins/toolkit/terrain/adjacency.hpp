// Inside of the terrain library: which triangles share an edge, and what follows from the corners alone.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "terrain/terrain.hpp"

namespace foothold::terrain {

// The vertex in the middle of an edge that was cut, by the edge.
using Midpoints = std::unordered_map<std::uint64_t, int>;
inline std::uint64_t edge_key(int a, int b) {
  const auto low = static_cast<std::uint64_t>(a < b ? a : b), high = static_cast<std::uint64_t>(a < b ? b : a);
  return low << 32 | high;
}

// Fills `adjacent`: triangles with a whole edge in common, or with an edge that `midpoints` tell to be a part of the other's.
void find_adjacent(Terrain& terrain, const Midpoints& midpoints);

// Fills `normals` and `centroids`.
void find_normals(Terrain& terrain);

}  // namespace foothold::terrain
