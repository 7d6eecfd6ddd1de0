// Walks: footsteps, and the certified strides that take them.
//
// Footsteps are found on the lattice; a placement counts if the sole has room there, the strides to it and away from it exist
// (gait/), and the robot fits among the obstacles. To know the latter two takes postures and motions: so the first rows of
// footsteps are searched for with room for the soles alone, and their strides certified where they are to be made. Where one fails,
// its placement is taken out and the search begins again; after some rows the search judges every placement that it takes itself.
// That the walk is least is then proved among all placements that count, so that what is proved is a walk, not a row of footprints.
//
// Metres, radians, seconds. Used by one thread at a time.
#pragma once

#include <map>
#include <optional>

#include "bioloid/gait/gait.hpp"
#include "bioloid/steps/footing.hpp"
#include "bioloid/steps/footsteps.hpp"

namespace foothold::bioloid {

struct WalkOptions {
  StepOptions steps;
  double step_over = 0.02;  // of obstacles that feet may pass over
  int most_routes = 40;     // rows of footsteps that may fail for a stride
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
  std::size_t least = 0;     // placements, proved, if found
  std::size_t expanded = 0;  // nodes of all searches
  int routes = 0;            // rows of footsteps whose strides were looked for
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
  enum class Depth { kRoom, kWhole };         // whether what takes postures and motions is asked too
  static constexpr double kLiftStep = 0.005;  // m: lifts are multiples of it, so that strides repeat
  static constexpr int kHigherLifts = 3;      // tried where lines between key postures sag onto obstacles
  using Spot = std::array<std::int64_t, 4>;   // a foot's place
  using Ban = std::array<std::int64_t, 7>;    // a placement

  static Spot spot_of(Side side, const PlanarPose& at);
  static Ban ban_of(const Placing& placing);
  double lift_over(double height) const;
  std::optional<double> lift_for(Side support, const PlanarPose& sole, const PlanarPose& place) const;
  Hindrance room(Side side, const PlanarPose& sole);
  Hindrance judge(const Placing& placing, Depth depth);
  Hindrance look(const Placing& placing, Depth depth);
  Hindrance reaches(Side support, const PlanarPose& place, double lift, Depth depth);
  // Whether the robot fits among the obstacles with its feet so, its weight between them, over the standing one, and the other
  // lifted.
  bool passes(Side support, const PlanarPose& sole, const PlanarPose& place, double lift);
  bool near(const PlanarPose& sole) const;
  bool clear(const std::vector<Phase>& phases, const PlanarPose& sole);
  bool fits(Side foot, const PlanarPose& sole);
  bool departs(Side support, const PlanarPose& sole, const PlanarPose& place);
  std::optional<Stride> stride(Side support, const PlanarPose& sole, const PlanarPose& from, const PlanarPose& to,
                               std::mt19937_64& random, std::stop_token stop);
  // By the paper's methods (GaitOptions::paper): the lifted sole's way is theirs, round the obstacles, or there is none.
  std::optional<Stride> stride_among(Side support, const PlanarPose& sole, const PlanarPose& from, const PlanarPose& to,
                                     std::mt19937_64& random, std::stop_token stop);
  std::optional<std::vector<WalkStep>> strides(const Feet& start, const std::vector<Footstep>& row, std::mt19937_64& random,
                                               std::stop_token stop);

  const Model& model_;
  Gait& gait_;
  WalkOptions options_;
  const std::vector<Prism>& prisms_;
  Judge among_;  // the obstacles
  std::map<Spot, Hindrance> rooms_;
  std::map<Ban, Hindrance> judged_;                               // placements near obstacles
  std::map<std::pair<Ban, Ban>, std::optional<Stride>> strides_;  // near obstacles
  std::vector<Placing> failed_;                                   // that count, but had no stride after the placement before
  std::array<std::size_t, 5> hindrances_{};
};

}  // namespace foothold::bioloid
