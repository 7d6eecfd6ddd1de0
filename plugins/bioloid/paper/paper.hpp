// The paper's two generators of movements from one point to another, in n dimensions (Bioloid paper, section II.D): the fully
// random one and the stochastic one, which mixes deterministic and random rules.
//
// Where the paper can be read in two ways, the files random.cpp, stochastic.cpp and sections.cpp say which one was taken. Any
// thread.
#pragma once

#include <random>
#include <stop_token>
#include <vector>

#include "bioloid/paper/space.hpp"

namespace foothold::bioloid::paper {

enum class Method { kRandom, kStochastic };

struct Options {
  Method method = Method::kStochastic;
  bool clean = true;                   // random: the useless sections are removed (paper, Figure 7)
  bool trim = true;                    // the last trimming, by equal Cartesian positions
  std::size_t iterations = 1'000'000;  // at most
  int growth = 3;                      // stochastic: a hole is jumped by up to so many steps at once; 1: never
  std::size_t patience = 150;          // stochastic: iterations of one way round an obstacle before there is "no advance"
};

enum class Ending { kReached, kCapped, kStopped };

struct Plan {
  Ending ending = Ending::kCapped;
  // From start to goal, both included, each movement valid; empty unless reached.
  std::vector<Point> path;
  std::size_t iterations = 0;       // points proposed and judged, both methods alike
  std::size_t found_movements = 0;  // before anything was removed
  std::size_t returns = 0;          // stochastic: how often the best approach was taken up again
  std::size_t jumps = 0;            // stochastic: holes jumped

  std::size_t movements() const { return path.empty() ? 0 : path.size() - 1; }
};

// Throws std::invalid_argument if limits, steps, start and goal do not fit together, or start or goal is not valid.
// `stop` is looked at every iteration.
Plan plan(const Space& space, const Point& start, const Point& goal, const Options& options, std::mt19937_64& random,
          std::stop_token stop = {});

}  // namespace foothold::bioloid::paper
