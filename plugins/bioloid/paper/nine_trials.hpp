// The paper's way through a single support: trials of one of its methods between two postures, and the best of them. Radians.
#pragma once

#include "bioloid/paper/nine_space.hpp"

namespace foothold::bioloid::paper {

struct NineTrials {
  std::vector<Trial> trials;
  std::optional<std::size_t> best;  // index of the trial; none if none reached its goal, or `a` or `b` is not valid
  std::vector<Joints> postures;     // of the best one, `a` and `b` included; each line between neighbours certified, if so asked
};

// Both postures with the swing sole level, as couple() gives them. `count` trials, fewer when stopped. The judge's thread.
NineTrials nine_trials(const Model& model, Judge& judge, const Support& support, const Joints& a, const Joints& b,
                       const NineOptions& nine, const Options& options, std::size_t count, Choice choice, std::mt19937_64& random,
                       std::stop_token stop = {});

}  // namespace foothold::bioloid::paper
