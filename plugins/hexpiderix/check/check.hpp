// Judges a step of Hex-piderix without the search's kinematics, margins or collision tests.
#pragma once

#include "foothold/planner.hpp"
#include "hexpiderix/model/model.hpp"
#include "terrain/surface.hpp"

namespace foothold::hexpiderix {

struct CheckOptions {
  double clearance = 0.0;   // m
  double friction = 0.0;    // that there is
  double least_nesm = 0.0;  // m, demanded on the way, as far as both of its ends have it
};

// Feet on the surface within 1e-6 m by the legs' forward kinematics, joints' limits, no leg or thorax through the terrain or each
// other, NESM by its definition above 0, equilibrium with the friction given; the motion begins at `before`, ends at `step.after`,
// keeps the feet that stand in both where they are, and on those alone the robot keeps its stability all along. Refusals name the
// leg and the values. Any thread.
StepVerdict check_step(const Model& model, const terrain::Surface& surface, const Step& step, const Posture& before,
                       const CheckOptions& options);

}  // namespace foothold::hexpiderix
