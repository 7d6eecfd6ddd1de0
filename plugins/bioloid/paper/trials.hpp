// The paper's statistics (section III, Figure 17): many trials of one movement, and the best of them. Any thread.
#pragma once

#include <functional>
#include <optional>

#include "bioloid/paper/paper.hpp"

namespace foothold::bioloid::paper {

// By what the best trial is chosen: fast execution, good balance, or never near to what is not valid.
enum class Choice { kFewestIterations, kLeastError, kLeastVariance };

// Distance of the projected centre of mass to the centre of the supporting sole at a point (paper, Figure 15; Balance::error).
using Error = std::function<double(const Point&)>;

struct Trial {
  Plan plan;
  double mean_error = 0.0;      // over the path's points, in the unit of Error
  double error_variance = 0.0;  // over the path's points (divided by their number), its square
};

// `count` trials, each with a generator of its own that is seeded from `random`. Stops early when asked to: fewer trials then.
std::vector<Trial> trials(const Space& space, const Point& start, const Point& goal, const Options& options, std::size_t count,
                          const Error& error, std::mt19937_64& random, std::stop_token stop = {});

// Index of the best trial that reached its goal, the first among equals; nothing if none did.
std::optional<std::size_t> best(const std::vector<Trial>& trials, Choice choice);

}  // namespace foothold::bioloid::paper
