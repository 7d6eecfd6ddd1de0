// The lifted sole's way by one of the paper's methods (paper/): trials between two postures, the best of them as a certified phase.
// Radians.
#pragma once

#include "bioloid/gait/phase.hpp"
#include "bioloid/gait/swing.hpp"
#include "bioloid/paper/nine_trials.hpp"

namespace foothold::bioloid {

struct PaperOptions {
  paper::Options method;
  paper::NineOptions nine;
  std::size_t trials = 1;
  paper::Choice choice = paper::Choice::kFewestIterations;
};

// Sums over the single supports of a plan.
struct PaperFigures {
  std::size_t ways = 0;   // asked for
  std::size_t found = 0;  // of them
  std::size_t trials = 0, reached = 0, iterations = 0;
  std::size_t movements = 0;  // of the best trials
};

// From a to b, both in the air, at the pace; empty if no trial reached b or the best one's phase cannot be certified. A corner of
// the way is cut as finely as samples are, or not at all.
std::optional<Phase> paper_way(const Model& model, Judge& judge, const Support& support, const Free& a, const Free& b,
                               const Pace& pace, const PaperOptions& options, PaperFigures& figures, std::mt19937_64& random,
                               std::stop_token stop);

}  // namespace foothold::bioloid
