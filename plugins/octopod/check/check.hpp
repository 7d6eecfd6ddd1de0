// Judges a step of the octopod without the search's tables, its equilibrium or its collision tests.
#pragma once

#include "foothold/planner.hpp"
#include "octopod/model/model.hpp"

namespace foothold::terrain {
class Surface;
}

namespace foothold::octopod {

struct CheckOptions {
  bool stability = true;
  bool transitions = true;
  double friction = 0.4;
  int cone_edges = 10;     // 0: the exact circular cone
  double clearance = 0.0;  // m
};

// Feet on the surface within 1e-6 m, legs' forward kinematics, modules joined, equilibrium by the other formulation, no body or leg
// through the terrain or through another; with transitions the same at every instant of the motion, which begins at `before` and
// ends at `step.after`. Refusals name the leg and the values. Margins: friction left, residual, clearances. Any thread.
StepVerdict check_step(const Model& model, const terrain::Surface& surface, const Step& step, const Posture& before,
                       const CheckOptions& options);

}  // namespace foothold::octopod
