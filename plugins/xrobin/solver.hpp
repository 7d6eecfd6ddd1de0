// Words for a goal in the open plane, by the paper's method and by those that prove what they find.
//
// `cycles` are searched at once. A goal that they cannot meet is approached and planned for from there: greedy goes on from where
// it is (the paper's section 4); optimal and fewest put as few cycles of approach as possible before a last search over all
// `cycles`.
#pragma once

#include <map>
#include <memory>

#include "brute_force.hpp"
#include "greedy.hpp"
#include "origins.hpp"
#include "pair_search.hpp"

namespace foothold::xrobin {

enum class Method { kOptimal, kFewest, kGreedy, kBruteForce };

struct Limits {
  int cycles = 7;           // searched at once
  int max_cycles = 70;      // of the whole plan
  double tolerance = 1e-3;  // m
  bool early_stop = true;   // greedy: no cycles that only fold the arm up
};

struct Solution {
  Word word;
  double distance = 0.0;        // m, from the word's end to the goal
  double least_distance = 0.0;  // m, proved for every word of at most `proved_cycles` cycles
  int proved_cycles = 0;
  int least_cycles = 0;  // proved: no word of fewer cycles meets the tolerance
  bool possible = true;  // false: no word of any length ends in the wanted heading
  bool no_way = false;   // proved: obstacles part the start from the goal
  bool no_room = false;  // proved: obstacles leave no room to stand at the goal
  bool stopped = false;
};

// Not thread-safe: keeps what depends on the robot alone once it is made.
class Solver {
 public:
  explicit Solver(const Mechanism& mechanism) : mechanism_(mechanism), half_cycles_(mechanism) {}

  // Makes the tables for a method. Returns false if stopped; calling it again goes on.
  bool prepare(Method method, int cycles, int grid_cells, bool obstacles, const std::stop_token& stop);
  // prepare() of the same method, cycles and grid cells must have been called.
  Solution solve(Method method, const Target& goal, const Limits& limits, const std::stop_token& stop) const;

  const Mechanism& mechanism() const { return mechanism_; }
  const HalfCycles& half_cycles() const { return half_cycles_; }
  const PairSearch& search(int cycles) const { return *searches_.at(cycles); }
  const Greedy& greedy() const { return *greedy_; }
  const Origins* origins() const { return origins_.get(); }  // null unless prepared for obstacles

 private:
  Solution optimal(const Target& goal, const Limits& limits, const std::stop_token& stop) const;
  Solution fewest(const Target& goal, const Limits& limits, const std::stop_token& stop) const;
  Solution greedy_words(const Target& goal, const Limits& limits, const std::stop_token& stop) const;
  Solution brute_force(const Target& goal, const Limits& limits, const std::stop_token& stop) const;
  // The best word of at most `cycles` cycles, of the fewest among equally good ones.
  Solution best_within(const Target& goal, int cycles, const std::stop_token& stop) const;
  // With an approach of its own before the last search; betters `solution` if it can.
  void go_farther(Solution& solution, const Target& goal, const Limits& limits, const std::stop_token& stop) const;
  bool heading_met(const PlanarPose& at, const Target& goal) const;

  Mechanism mechanism_;
  HalfCycles half_cycles_;
  std::map<int, std::unique_ptr<PairSearch>> searches_;
  std::unique_ptr<Greedy> greedy_;
  std::unique_ptr<Origins> origins_;
};

}  // namespace foothold::xrobin
