// Postures that a robot may take on two footholds between two strides.
#pragma once

#include <string>
#include <vector>

#include "hyrecro/motion/clear_way.hpp"
#include "hyrecro/reach/reachability.hpp"

namespace foothold::hyrecro {

// A posture on two footholds, seen from the foot that held when it was reached.
struct Stance {
  Coordinates coordinates;
  Actuators landing, leaving;        // with the foot lifted: just before (same view), and just after (seen from the other foot)
  bool lands = true, leaves = true;  // one leg alone has room to lift its foot
  double cost = 0.0;                 // s: how far from the middle of their strokes the actuators are, more without room to lift
};
Stance stance_of(const Model& model, const Coordinates& coordinates, double height);

// Some stances with the free sole at `placed` (world), free of collisions, in the middle of the strokes where possible, on both
// sides of the hip; `given` is the last of them. `last`: the other foot need not be lifted from there. Empty if exact reachability
// has no posture with the one or the other foot `height` (m) above its place; then `reason` says so. Thread rule of Surroundings.
std::vector<Stance> stances_at(const Surroundings& around, Reachability& exact, const Isometry3d& placed, const Coordinates& given,
                               bool last, double height, std::string& reason);

}  // namespace foothold::hyrecro
