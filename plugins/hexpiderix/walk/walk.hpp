// Walking by alternating tripods over any ground: while three feet hold, the thorax moves on and the other three swing to where
// they will hold next. Every instant keeps a stability (NESM) above a bound.
//
// Metres, radians, world frame. Values; any thread.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "hexpiderix/ground.hpp"
#include "hexpiderix/model/body.hpp"

namespace foothold::hexpiderix {

struct WalkOptions {
  double stride = 0.06;      // m, of the thorax in half a cycle, at most
  double turn = 0.15;        // rad, of the heading in half a cycle, at most
  double least_nesm = 5e-3;  // m, at every instant
  double friction = 100.0;   // that there is; at every instant, too
  double clearance = 0.0;    // m, of legs and thorax from the ground and each other
  double swing = 0.03;       // m, that a swinging foot rises above both footholds and what lies between, at least
};

// Where the robot stands with all six feet on the ground.
struct Stand {
  Coordinates at;
  Footholds feet;
};

// The legs that are not `swinging` hold while the thorax moves from one stand to the next.
struct HalfCycle {
  Legs swinging;
  Stand to;
  std::vector<Coordinates> way;  // from stand to stand, evenly in time
  double least_nesm = 0.0;       // m, on the way, instants between the points included
};

// A place to be: over a point of the ground with a heading.
struct Station {
  Vector3d place;
  double heading;  // rad, of leg 1, seen from above
};

struct Walk {
  enum class End { kArrived, kBlocked, kStopped };
  End end = End::kBlocked;
  std::vector<HalfCycle> half_cycles;
  std::string because;  // of kBlocked: where the farthest try ended and what was in the way
  Vector3d farthest = Vector3d::Zero();
  long tried = 0;  // half cycles judged
};

// Standing with six feet at a station: among some heights, shifts and inclinations of the thorax the one of greatest NESM of both
// tripods. Empty if there is none; `because` says why.
std::optional<Stand> stand_at(const Model& model, const Ground& ground, const Station& station, const WalkOptions& options,
                              std::string* because = nullptr);

// To the goal: straight on, with shorter strides where it must be, and round what cannot be walked over.
Walk walk(const Model& model, const Ground& ground, const Stand& from, const Station& goal, const WalkOptions& options,
          const std::stop_token& stop);

}  // namespace foothold::hexpiderix
