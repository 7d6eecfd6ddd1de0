// The judge's own view of the robot against itself: which parts must keep apart, and how far apart they are.
#pragma once

#include <array>
#include <string>

#include "octopod/check/setting.hpp"

namespace foothold::octopod {

// Two bodies by their numbers (bodies.hpp), but tibiae down to their soles.
struct Parts {
  int a = 0, b = 0;
};

// All that do not hang together: not a femur with its tibia or its own module, not a neck with its body or the other neck.
inline constexpr std::size_t kPairs = 120 - 8 + (64 - 16) + 3;
const std::array<Parts, kPairs>& parts_apart();

// m, between the surfaces, 0 where they meet; looked for up to `reach` (m).
double parts_distance(const Model& model, const Skeleton& at, const Parts& parts, double reach);

// All parts of one posture keep the clearance from each other. Refuses with `where` and both names. Returns the least distance, m.
double judge_apart(const Setting& setting, const Skeleton& at, const std::string& where);

}  // namespace foothold::octopod
