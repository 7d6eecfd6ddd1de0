// From one standing posture to the next: legs lifted one after the other, bodies moved between, so that the robot is in equilibrium
// and every supporting foot in reach at every instant. The paper leaves this open.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "octopod/search/ground.hpp"

namespace foothold::octopod {

// A part of the way: the bodies move with all feet down (leg -1), or one leg lifts, swings and comes down.
struct Phase {
  int leg = -1;
  std::vector<Coordinates> way;  // linear between; begins where the phase before ended
};

struct Transition {
  std::vector<Phase> phases;
  double least_margin = 0.0;  // friction left: given friction less the critical one, least over all stances
};

struct TransitionFailure {
  int leg = -1;         // the leg that cannot be moved in the farthest order that was found
  std::string because;  // "A2 out of reach by 0.012 m", "no equilibrium without B3"
};

// Finds an order. `swing_height` (m): a swinging foot rises so far along its normals. Both postures must be stable. Any thread.
std::optional<Transition> transition(const Ground& ground, const Standing& from, const Standing& to, double swing_height,
                                     TransitionFailure* failure = nullptr);
// The same yes or no, without the way. Used by the search.
bool has_transition(const Ground& ground, const Standing& from, const Standing& to, double swing_height);

// As the interface wants it: times within the robot's speeds.
std::vector<MotionPoint> to_motion(const Model& model, const Transition& transition);

}  // namespace foothold::octopod
