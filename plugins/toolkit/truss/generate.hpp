// Trusses from a seed: what searches are tested and measured on.
//
// Portal frames (columns, girders, purlins), lattice towers (legs, rings, diagonals, tapering) and bridge bays (chords, posts,
// diagonals, cross beams). Columns, legs and chords run through as one beam each; the others end at the axes of those, so all
// joints are welded ones, cut where members meet. Sizes are multiples of a millimetre. The same seed gives the same layout on every
// machine: own draws from mt19937_64, no transcendental functions.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "truss/layout.hpp"

namespace foothold::truss {

enum class Family { kPortal, kTower, kBridge };
std::optional<Family> family_named(std::string_view name);  // "portal", "tower", "bridge"

inline constexpr int kFewestBeams = 2, kMostBeams = 2000;

// Exactly `beams` beams (kFewestBeams to kMostBeams), each joined to an earlier one; profiles from 0.12 to 0.30 m. Any thread.
Layout generate(Family family, std::uint64_t seed, int beams);

}  // namespace foothold::truss
