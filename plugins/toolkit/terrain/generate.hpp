// Terrains from a seed: what searches are tested and measured on.
//
// The same family, seed and size give the same terrain on every machine: own draws from mt19937_64, no transcendental functions,
// coordinates multiples of a tenth of a millimetre (but for ramps).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "terrain/terrain.hpp"

namespace foothold::terrain {

enum class Family : std::uint8_t { kRamps, kBoulders, kStairs, kDitch };
std::optional<Family> family_named(std::string_view name);  // "ramps", "boulders", "stairs", "ditch"

struct Options {
  std::uint64_t seed = 1;
  double size = 4.0;   // m, edge of the square terrain; 1 to 100
  double grid = 0.16;  // m, distance of vertices of boulders and ditch; 0.01 to 1; 700 fields a side at most
};

// The terrain of Molla-Santamaria et al. 2023, section 3, after its description: 2 x 2 x 0.9 m centred at x = y = 0, z from -0.5 to
// 0.4; 42 triangles, 1116 when cut to 0.2 m (the paper's own, which is not published: 1176). From the floor (-0.5) three ramps run
// in turn along the walls x = 1, y = 1 and x = -1 (14.5, 6.3 and 18.4 deg) to 0.4. The slopes between floor and ramps are 34 to 62
// deg: the short cuts, on which a robot slides at friction 0.4 (21.8 deg). The paper's points lie on it: P_O (0, 0, -0.5) on the
// floor, P_A (0, 0.75, -0.2) on the second ramp, P_B (-1, -0.4, 0.2) on the third.
Terrain ramps();

// kRamps takes nothing from the options. kBoulders: rocks of 0.2 to 0.6 m radius on uneven ground. kStairs: a flight of steps as
// wide as the terrain between two landings, with upright risers (obstacles). kDitch: a ditch across, too wide to step over, with
// one gentle crossing. Throws std::invalid_argument for options out of range.
Terrain generate(Family family, const Options& options);

}  // namespace foothold::terrain
