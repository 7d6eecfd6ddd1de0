// Meet in the middle: the pair of n half cycles and n half cycles whose end lies nearest to a target, proved over all pairs.
//
// A plan of n cycles is P s^-1 with P and s in level n of HalfCycles (the second half, read backwards, is a first half again).
// With q(P) = P^-1 (origin) its end lies at a distance | R(P)^-1 t + q(P) - q(s) | from the target t: a nearest-neighbour search
// in one set of points q, shifted by one vector for each heading. The paper fixes one module after the other instead and misses
// the best end point by a factor of ten and more.
#pragma once

#include <functional>
#include <optional>

#include "pair_index.hpp"

namespace foothold::xrobin {

// Where body A shall be, in the frame of body A before the first half cycle.
struct Target {
  double x = 0.0;
  double y = 0.0;
  std::optional<double> heading;  // rad
  double heading_tolerance = 0.0;
};

// The same goal as body A sees it from `from`.
Target seen_from(const PlanarPose& from, const Target& goal);

struct Pair {
  std::uint32_t prefix = 0;
  std::uint32_t suffix = 0;
  double distance = 0.0;  // m
};

// Pairs at a distance of `inner` or more and less than `outer` (m), the nearest `most` of them.
struct PairRange {
  double inner = 0.0;
  double outer = 0.0;
  std::size_t most = 0;
  const std::vector<char>* live = nullptr;  // of each prefix: pairs of those that are 0 are left out
};

// In the order of the distance; all there are that are nearer than `complete_to` (m).
struct PairBatch {
  std::vector<Pair> pairs;
  double complete_to = 0.0;
};

// Immutable; any thread. Keeps a pointer to the half cycles, which must not grow meanwhile.
class PairSearch {
 public:
  PairSearch(const HalfCycles& half_cycles, int n);
  // The nearest pair among those nearer than `bound` (m); none if there is no such pair or the search was stopped.
  std::optional<Pair> closest(const Target& target, double bound, const std::stop_token& stop) const;
  // The pairs of a range that are `wanted`; a few more than `most` if their last distance is that of several. None if stopped.
  std::optional<PairBatch> batch(const Target& target, const PairRange& range, const std::function<bool(const Pair&)>& wanted,
                                 const std::stop_token& stop) const;
  Word word(const Pair& pair) const;
  // Body A after the word, as the merged poses have it.
  PlanarPose end(const Pair& pair) const;
  // In m: the end of no word is farther than this from the end of the pair that stands for it.
  double merge_bound() const;
  int cycles() const { return n_; }
  const PairIndex& index() const { return index_; }

 private:
  const HalfCycles* half_cycles_;
  int n_;
  PairIndex index_;
};

}  // namespace foothold::xrobin
