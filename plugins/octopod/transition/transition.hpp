// From one standing posture to the next: legs lifted one after the other, bodies moved between, so that the robot is in equilibrium
// and every supporting foot in reach at every instant. The paper leaves this open.
//
// The bodies go straight from posture to posture, in as many equal phases as no shoulder moves more than 2.5 cm in. A state is
// (legs moved, phase): a move lifts one more leg over to its new foothold, or takes the bodies one phase on or back with all feet
// down. A search, least moves left first, finds an order. What holds between states is bounded, not sampled: reach by the distance
// at both ends and how far arcs bulge; equilibrium because the places of the centre of mass at which given contacts hold are
// convex, so that the corners of squares round the ends decide, squares wider than the centre of mass leaves the straight line;
// clearance from the ground and of legs and bodies from each other by distances less the ways of bodies and knees.
#pragma once

#include <optional>
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
  Standing to;  // where it ends
  std::vector<Phase> phases;
  double least_margin = 0.0;  // friction left: given friction less the critical one, least over all stances
};

struct TransitionFailure {
  int leg = -1;         // the leg that cannot be moved in the farthest order that was found
  std::string because;  // "out of reach", "no equilibrium without B3"
};

struct TransitionOptions {
  double friction = 0.4;
  int cone_edges = 10;         // 0: the exact circular cone
  double clearance = 0.0;      // m, bodies and legs above the ground and from each other
  double swing_height = 0.04;  // m, a swinging foot rises so far along its normals; up to three times as far over obstacles
};
inline TransitionOptions transition_options(const Ground& ground, double swing_height) {
  return {ground.options().friction, ground.options().cone_edges, ground.options().clearance, swing_height};
}

// Finds an order. Both postures must be stable and as stand() makes them (legs on their standing branch); else there is none. Any
// thread.
std::optional<Transition> transition(const Model& model, const terrain::Surface& surface, const TransitionOptions& options,
                                     const Standing& from, const Standing& to, TransitionFailure* failure = nullptr);
// The same yes or no, without the way.
bool has_transition(const Model& model, const terrain::Surface& surface, const TransitionOptions& options, const Standing& from,
                    const Standing& to);

// Over stops where footholds are too far apart for one go, as in a turn by 45 degrees: the bodies half way between, feet down to
// the nearest points there, in equilibrium; then each half likewise, up to eight parts. Each part is a step of its own, from the
// stop before to its `to`. Empty if there is none; `failure` then tells why the direct one is not.
std::vector<Transition> transitions(const Model& model, const terrain::Surface& surface, const TransitionOptions& options,
                                    const Standing& from, const Standing& to, TransitionFailure* failure = nullptr);
// The same yes or no. Used by the search.
bool has_transitions(const Model& model, const terrain::Surface& surface, const TransitionOptions& options, const Standing& from,
                     const Standing& to);

// With the options of a ground.
inline std::optional<Transition> transition(const Ground& ground, const Standing& from, const Standing& to, double swing_height,
                                            TransitionFailure* failure = nullptr) {
  return transition(ground.model(), ground.surface(), transition_options(ground, swing_height), from, to, failure);
}
inline bool has_transition(const Ground& ground, const Standing& from, const Standing& to, double swing_height) {
  return has_transition(ground.model(), ground.surface(), transition_options(ground, swing_height), from, to);
}
inline std::vector<Transition> transitions(const Ground& ground, const Standing& from, const Standing& to, double swing_height,
                                           TransitionFailure* failure = nullptr) {
  return transitions(ground.model(), ground.surface(), transition_options(ground, swing_height), from, to, failure);
}
inline bool has_transitions(const Ground& ground, const Standing& from, const Standing& to, double swing_height) {
  return has_transitions(ground.model(), ground.surface(), transition_options(ground, swing_height), from, to);
}

// As the interface wants it: times within the robot's speeds, joints linear between the points.
std::vector<MotionPoint> to_motion(const Model& model, const Transition& transition);

}  // namespace foothold::octopod
