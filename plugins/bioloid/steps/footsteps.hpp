// Footsteps over flat ground: the fewest placements of alternate feet from where the robot stands to where it shall stand.
//
// A foot's place is given by its base point: the sole's centre moved by half the hips' spacing towards the other foot, so that
// parallel feet side by side share one base point. Base points lie on a lattice (cells and headings anchored in the first
// supporting foot); start and goal lie where they are, exactly. A placement may move the base point, seen from the standing foot's,
// within half ellipses of `length` and `width`, and turn it by multiples of the lattice's heading up to `turn`.
//
// Weighted A* finds a good route fast (Pohl, 1970); A* proves it least among all on the lattice whose placements are accepted, or
// finds a better one. Its bound lets every placement go as far towards the goal as the heading allows that the robot can have
// turned to by then, and can still turn back from; one placement more closes the feet.
//
// Metres and radians. Values; any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "bioloid/gait/planar.hpp"
#include "bioloid/model/model.hpp"

namespace foothold::bioloid {

struct StepOptions {
  double length = 0.05;       // of the base point's way forward
  double back = 0.03;         // and backward
  double width = 0.03;        // and outward (inward: one cell)
  double turn = M_PI / 12.0;  // of one placement
  double cell = 0.01;
  double heading = M_PI / 12.0;     // of the lattice; divides a right angle
  std::size_t most_nodes = 100000;  // of the first search
  std::size_t proof_nodes = 5000;   // of the second; where it ends before the proof, the route says how far it got
};

// Both soles in the world.
struct Feet {
  PlanarPose right, left;
  const PlanarPose& of(Side side) const { return side == Side::kRight ? right : left; }
  PlanarPose& of(Side side) { return side == Side::kRight ? right : left; }
};

struct FootstepGoal {
  PlanarPose base;  // of both feet
  bool any_heading = false;
};

// A placement as it is judged: the foot that stands, and where the other shall go, seen from it.
struct Placing {
  Side support = Side::kRight;
  PlanarPose sole;   // of the standing foot, in the world
  PlanarPose place;  // of the other sole, seen from the standing one
};

struct Footstep {
  Side foot = Side::kRight;  // the one that moves
  PlanarPose sole;           // where to, in the world
};

struct Footsteps {
  enum class End { kFound, kNone, kTooMany, kStopped };
  End end = End::kNone;
  std::vector<Footstep> steps;
  std::size_t least = 0;     // proved (least_footsteps): no route of the lattice has fewer placements
  std::size_t expanded = 0;  // nodes
};

// What a search asks of placements; each may ask as many times as it likes.
struct Acceptance {
  // Whether nothing but `reaches` is asked of the placements from where this sole stands. Cheap: asked of every placement seen.
  std::function<bool(const PlanarPose&)> open;
  // Knows no place: the foot that stands and the other's place seen from it. Asked once for each on the lattice.
  std::function<bool(Side, const PlanarPose&)> reaches;
  // Everything, of those that are not open. Asked when a placement is taken.
  std::function<bool(const Placing&)> accept;
};

// A good route. `half_spacing`: of the hips.
Footsteps find_footsteps(const Feet& start, const FootstepGoal& goal, double half_spacing, const StepOptions& options,
                         const Acceptance& acceptance, std::stop_token stop = {});
// The least route of fewer than `below` placements: kFound. Else kNone, with `least` = `below`: there is none; or kTooMany after
// `most` nodes, with what was proved by then.
Footsteps least_footsteps(const Feet& start, const FootstepGoal& goal, double half_spacing, const StepOptions& options,
                          std::size_t below, std::size_t most, const Acceptance& acceptance, std::stop_token stop = {});

// Base point of a sole, and the sole at a base point.
PlanarPose base_of(Side side, const PlanarPose& sole, double half_spacing);
PlanarPose sole_at(Side side, const PlanarPose& base, double half_spacing);

// Whether the other foot's base point may go to `to`, seen from the standing foot's.
bool within_step(Side support, const PlanarPose& to, const StepOptions& options);

}  // namespace foothold::bioloid
