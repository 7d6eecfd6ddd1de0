// Walks: footsteps, and the certified strides that take them.
//
// Footsteps are found on the lattice; a placement counts if the sole has room there, the strides to it and away from it exist
// (gait/), and the robot fits among the obstacles. The strides of the route are then certified where they are to be made; a
// placement whose stride fails is taken out and the search begins again, so that what is proved least is a walk, not a row of
// footprints.
//
// Metres, radians, seconds. Used by one thread at a time.
#pragma once

#include <map>

#include "bioloid/gait/gait.hpp"
#include "bioloid/steps/footing.hpp"
#include "bioloid/steps/footsteps.hpp"

namespace foothold::bioloid {

struct WalkOptions {
  StepOptions steps;
  double step_over = 0.02;  // of obstacles that feet may pass over
  int most_routes = 40;     // until strides are found for one
};

struct WalkStep {
  PlanarPose support;  // of the standing sole, in the world
  Stride stride;
  Feet after;
};

struct Walk {
  enum class End { kFound, kNoFootsteps, kTooMany, kNoStrides, kStopped };
  End end = End::kNoFootsteps;
  std::vector<WalkStep> steps;
  std::size_t least = 0;     // placements, proved
  std::size_t expanded = 0;  // nodes of all searches
  int routes = 0;            // searched
  std::string hindrance;     // what was in the way most of the time, if no way was found
};

class Walker {
 public:
  // `gait` and `prisms` have to outlive it.
  Walker(const Model& model, Gait& gait, const WalkOptions& options, const std::vector<Prism>& prisms);

  Walk walk(const Feet& start, const FootstepGoal& goal, std::mt19937_64& random, std::stop_token stop);

  // Why feet cannot stand at a place; empty if they can.
  std::string refusal(Side side, const PlanarPose& sole);
  double half_spacing() const;  // of soles side by side

 private:
  enum class Hindrance { kNone, kObstacle, kHeight, kReach, kBody };
  using Ban = std::array<double, 7>;

  double lift_over(double height) const;
  std::optional<double> lift_for(Side support, const PlanarPose& sole, const PlanarPose& place) const;
  Hindrance judge(const Placing& placing);
  Hindrance look(const Placing& placing);
  // Whether the robot fits among the obstacles with its feet so, its weight between them, over the standing one, and the other
  // lifted.
  bool passes(Side support, const PlanarPose& sole, const PlanarPose& place, double lift);
  static bool near(const std::vector<Prism>& prisms, const PlanarPose& sole);
  bool clear(const std::vector<Phase>& phases, const PlanarPose& sole);
  bool fits(Side foot, const PlanarPose& sole);
  std::optional<Stride> stride(Side support, const PlanarPose& sole, const PlanarPose& from, const PlanarPose& to,
                               std::mt19937_64& random, std::stop_token stop);

  const Model& model_;
  Gait& gait_;
  WalkOptions options_;
  const std::vector<Prism>& prisms_;
  Judge among_;                      // the obstacles
  std::map<Ban, Hindrance> judged_;  // placements near obstacles; those that failed as strides
  std::array<std::size_t, 5> hindrances_{};
};

}  // namespace foothold::bioloid
