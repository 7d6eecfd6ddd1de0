// Words for a goal among obstacles: the same methods and the same promises as in the open plane (solver.hpp), over words that can
// be walked.
//
// optimal and fewest are exact over at most `cycles` cycles, as far as `most_pairs` allows; a goal beyond them is approached
// (approach.hpp) and searched for exactly from there. greedy fixes one cycle after the other among those that can be walked.
#pragma once

#include "approach.hpp"
#include "solver.hpp"
#include "valid_pairs.hpp"

namespace foothold::xrobin {

struct ObstacleLimits {
  std::size_t most_pairs = 1000000;  // of half plans, looked at by one exact search
  std::size_t most_nodes = 20000;    // of the approach
};

// Not thread-safe; for one request. Keeps references to its arguments.
class ObstacleSolver {
 public:
  // solver.prepare() for the method and for obstacles must have been called.
  ObstacleSolver(const Solver& solver, Passage& passage, const Stance& start, const Target& goal, const Limits& limits,
                 const ObstacleLimits& obstacle_limits, std::stop_token stop);
  Solution solve(Method method);

 private:
  Solution optimal();
  Solution fewest();
  Solution greedy_words();
  Solution brute_force();
  // The nearest valid word of at most `cycles` cycles from a stance, of the fewest cycles among equally good ones.
  ValidWord best_within(const Stance& from, int cycles, double bound, std::size_t most_pairs);
  // The valid word of the fewest cycles that ends nearer than `bound`.
  ValidWord fewest_within(const Stance& from, int cycles, double bound);
  // With an approach before the exact search; betters `solution` if it can.
  void go_farther(Solution& solution, Method method);
  // Proved: no walk to the goal is of fewer cycles. One more than max_cycles if there is no way at all.
  int least_cycles() const;
  // False if it is proved that the robot cannot stand anywhere within the tolerance of the goal.
  bool room_at_goal() const;
  // The end of a word from `from`, and the configuration there.
  Stance after(const Stance& from, const Word& word) const;
  double away(const PlanarPose& at) const { return std::hypot(at.x - goal_.x, at.y - goal_.y); }
  bool heading_met(const PlanarPose& at) const;

  const Solver& solver_;
  const Mechanism& mechanism_;
  Passage& passage_;
  Stance start_;
  Target goal_;  // in the world
  Limits limits_;
  ObstacleLimits obstacle_limits_;
  std::stop_token stop_;
  geometry::Geodesic ways_;
  std::optional<ValidPairs> pairs_;  // of the methods that search exactly
};

// The ways round the ring that a word takes; none if a half cycle of it is blocked.
std::optional<Route> clear_ways(const Mechanism& mechanism, Passage& passage, const Stance& start, const Word& word);

}  // namespace foothold::xrobin
