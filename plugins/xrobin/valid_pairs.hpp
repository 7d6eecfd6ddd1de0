// The proved nearest word among obstacles: pairs of half plans in the order of their distance to the goal, each judged by whether
// any of the words that it stands for can really be walked.
//
// A pair stands for all words that pass through its middle pose and end in its end pose. They are judged at once: forward from the
// start and backward from the end (ReachTree), joined by a free way round the ring in the middle. The first pair that can be walked
// is the optimum, since all nearer ones have been refuted.
//
// Behind walls most pairs are refuted by one number. At rest the line between the centres of both bodies lies inside body A, so the
// centres of a walk form a way of a point past the obstacles, each link no longer than the travel in the slot; the shortest way
// of a point from the middle pose to the goal (Geodesic) says how many half cycles that takes at least.
#pragma once

#include "geometry/geodesic.hpp"
#include "near_goal.hpp"

namespace foothold::xrobin {

struct ValidWord {
  std::optional<Word> word;  // none: no word nearer than `excluded_to` can be walked
  double distance = 0.0;     // m, of the word
  double excluded_to = 0.0;  // m: everything nearer is refuted
  bool complete = false;     // false: the limit of pairs was met before the range was searched through
};

// Not thread-safe; for one request. Keeps references to its arguments.
class ValidPairs {
 public:
  // `ways` lead to the goal of all calls.
  ValidPairs(const HalfCycles& half_cycles, const Origins& origins, Passage& passage, const geometry::Geodesic& ways,
             int most_cycles);

  // The nearest word of exactly search.cycles() cycles that is nearer to the goal (in the world) than `bound`, from `start`.
  // Gives up after `most_pairs`.
  ValidWord nearest(const PairSearch& search, const Stance& start, const Target& goal, double bound, std::size_t most_pairs,
                    const std::stop_token& stop);

 private:
  // Whether the goal is too far from the middle of the pair, on foot, for the half cycles that are left.
  bool too_far(const PairSearch& search, const Pair& pair);
  // Which prefixes are not known to be out of reach.
  const std::vector<char>& live_prefixes(int n);
  std::optional<Word> walkable(const PairSearch& search, const Pair& pair);

  const HalfCycles* half_cycles_;
  const Origins* origins_;
  Passage* passage_;
  const geometry::Geodesic* ways_;
  double travel_;  // m, in the slot
  double beside_;  // m: so near to the goal a body at rest has nothing between them
  ReachTree forward_;
  ReachTree backward_;
  Stance start_;
  PlanarPose end_;
  bool end_planted_ = false;
  int most_cycles_;
  std::optional<NearGoal> near_goal_;  // once many pairs have been looked at
  std::vector<char> live_;
  std::vector<float> way_from_;  // from the pose of each prefix to the goal; negative: not yet asked
};

}  // namespace foothold::xrobin
