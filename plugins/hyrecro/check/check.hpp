// Judges a step of HyReCRo from joints, poses and the scene's solids alone: no tables of the search.
#pragma once

#include "foothold/planner.hpp"
#include "hyrecro/model/bodies.hpp"

namespace foothold::hyrecro {

// Judges `step` after `before`: forward kinematics from the sent joints gives the base and both contacts (1e-6 m, 1e-6 rad); the
// placed plate lies wholly on its face; actuators within their limits; bodies free of the scene and of each other by `clearance`
// (m); the foot that holds did not move; the motion likewise, from the posture before to the one after. `obstacles` are those of
// `truss`. Any thread.
StepVerdict check_step(const Model& model, const truss::Truss& truss, const Obstacles& obstacles, double clearance,
                       const Step& step, const Posture& before);

}  // namespace foothold::hyrecro
