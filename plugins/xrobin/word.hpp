// Words: which configuration Xrobin takes in each half cycle, and where it ends up.
//
// In half cycle 1, 3, 5, ... body A holds and B moves; in 2, 4, 6, ... B holds and A moves. One cycle is
//   T <- T * T(S1[i]) * T(S2[i])^-1   (the paper's section 3.1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mechanism.hpp"

namespace foothold::xrobin {

// Configuration numbers 1 to 8 in the order in which they are taken, two for each cycle.
using Word = std::vector<std::uint8_t>;

// Both bodies after a half cycle.
struct BodyPoses {
  PlanarPose a;
  PlanarPose b;
};

// Body A after the whole word, from A at `start`. The word must be of even length.
PlanarPose forward(const Mechanism& mechanism, std::span<const std::uint8_t> word, const PlanarPose& start = {});

// Both bodies after each half cycle, from A at `start`.
std::vector<BodyPoses> trace(const Mechanism& mechanism, std::span<const std::uint8_t> word, const PlanarPose& start = {});

// The paper's way of writing: S = [S1, S2], first all first half cycles, then all second ones.
Word from_paper(std::span<const int> first_halves, std::span<const int> second_halves);
std::vector<int> to_paper(std::span<const std::uint8_t> word);

}  // namespace foothold::xrobin
