// Judges a step of Hex-piderix without the search's kinematics, margins or collision tests.
#pragma once

#include "foothold/planner.hpp"
#include "hexpiderix/model/model.hpp"
#include "terrain/surface.hpp"

namespace foothold::hexpiderix {

struct CheckOptions {
  double clearance = 0.0;   // m
  double friction = 0.0;    // that there is
  double least_nesm = 0.0;  // m, demanded on the way
};

// Feet on the surface within 1e-6 m by the legs' forward kinematics, joints' limits, no leg or thorax through the terrain or each
// other, NESM by its definition above 0, equilibrium with the friction given; what is placed stands. A motion begins at `before`,
// ends at `step.after`, turns no joint too fast and keeps the feet that stand in both where they are; at every instant three feet
// or more are on footholds of either posture, and on those the robot keeps the stability demanded where both postures have it on
// the same legs, else one above 0; one that begins unstable keeps that as soon as it has it. Of a step without motion the posture
// after is judged. Refusals name the leg and the values. Any thread.
StepVerdict check_step(const Model& model, const terrain::Surface& surface, const Step& step, const Posture& before,
                       const CheckOptions& options);

}  // namespace foothold::hexpiderix
