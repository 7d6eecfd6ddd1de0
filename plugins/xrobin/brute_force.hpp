// The reference: every word of a few cycles, one by one. 64^n words, so 4 cycles (17 million words) at most.
#pragma once

#include <optional>
#include <stop_token>

#include "pair_search.hpp"
#include "passage.hpp"
#include "route.hpp"

namespace foothold::xrobin {

inline constexpr int kMostBruteForceCycles = 4;

struct BestWord {
  Word word;
  double distance = 0.0;  // m
};

// The first in the order of the numbers among the words of exactly `cycles` cycles that end nearest to the target; none if no
// word ends in the wanted heading or it was stopped. Throws std::invalid_argument for more than kMostBruteForceCycles.
std::optional<BestWord> best_of_all_words(const Mechanism& mechanism, int cycles, const Target& target,
                                          const std::stop_token& stop);

// The same over the words that can be walked among obstacles, from a stance; the goal is in the world.
std::optional<BestWord> best_of_all_walkable_words(const Mechanism& mechanism, Passage& passage, const Stance& start, int cycles,
                                                   const Target& goal, const std::stop_token& stop);

// The end of every word of exactly `cycles` cycles, with repetitions, in the order of the numbers.
std::vector<PlanarPose> ends_of_all_words(const Mechanism& mechanism, int cycles);

}  // namespace foothold::xrobin
