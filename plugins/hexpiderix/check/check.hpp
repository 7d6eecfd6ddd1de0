// Judges a step of Hex-piderix without the search's kinematics, margins or collision tests.
#pragma once

#include "foothold/planner.hpp"
#include "hexpiderix/model/model.hpp"
#include "terrain/surface.hpp"

namespace foothold::hexpiderix {

struct CheckOptions {
  double clearance = 0.0;  // m
  double friction = 0.0;   // that there is
};

// Feet on the surface within 1e-6 m by the legs' forward kinematics, joints' limits, no leg or thorax through the terrain or each
// other, NESM by its definition above 0, equilibrium with the friction given; the motion begins at `before`, ends at `step.after`
// and keeps supporting feet where they are. Refusals name the leg and the values. Any thread.
StepVerdict check_step(const Model& model, const terrain::Surface& surface, const Step& step, const Posture& before,
                       const CheckOptions& options);

}  // namespace foothold::hexpiderix
