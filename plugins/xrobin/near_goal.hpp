// What can be said at once of all ends near the goal: which second halves of a plan cannot lead there.
//
// Ends of plans that lie within a radius of the goal and have nearly the same heading are surrounded by nearly the same obstacles.
// Looking backward from the goal itself with bodies thinner by as much as those ends differ from it finds at least what can be
// walked from any of them; what it does not find is refuted for all of them together.
#pragma once

#include <array>
#include <memory>

#include "pair_search.hpp"
#include "reach_tree.hpp"

namespace foothold::xrobin {

// Less by `by` m on all sides; a piston may end up with less than nothing, which only makes it easier to pass.
Bodies thinner(const Bodies& bodies, double by);

// Not thread-safe; for one request. Keeps references to half cycles and origins.
class NearGoal {
 public:
  // Ends within `radius` (m) of the goal. Headings are told apart by eighths of a turn from `heading`.
  NearGoal(const HalfCycles& half_cycles, const Origins& origins, const Surroundings& surroundings, int most_levels,
           const Target& goal, double heading, double radius, const std::stop_token& stop);
  // False if the body that pose `suffix` of level `n` stands for, seen from any end near `end`, cannot be walked from.
  bool may_lead(int n, std::uint32_t suffix, const PlanarPose& end);
  double radius() const { return radius_; }

 private:
  // Ends whose heading differs from an eighth of a turn by more than this (rad) are not judged.
  static constexpr double kMostTurn = 1.5e-3;

  const HalfCycles* half_cycles_;
  const Origins* origins_;
  int most_levels_;
  Target goal_;
  double heading_;
  double radius_;
  Surroundings thinner_;
  Passage passage_;
  std::array<std::unique_ptr<ReachTree>, 8> trees_;
};

}  // namespace foothold::xrobin
