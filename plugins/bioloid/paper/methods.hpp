// The two methods apart, before anything is removed from their paths. See paper.hpp; preconditions are judged there.
#pragma once

#include "bioloid/paper/paper.hpp"

namespace foothold::bioloid::paper {

Plan random_walk(const Space& space, const Point& start, const Point& goal, const Options& options, std::mt19937_64& random,
                 std::stop_token stop);
Plan stochastic(const Space& space, const Point& start, const Point& goal, const Options& options, std::mt19937_64& random,
                std::stop_token stop);

}  // namespace foothold::bioloid::paper
