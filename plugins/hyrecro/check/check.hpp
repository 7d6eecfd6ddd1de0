// Judges a step of HyReCRo from joints, poses and the scene's solids alone: no tables of the search.
#pragma once

#include "foothold/planner.hpp"
#include "hyrecro/model/bodies.hpp"

namespace foothold::hyrecro {

struct CheckOptions {
  double clearance = 0.005;      // m: of legs and hip to the scene, and of the bodies among themselves
  double lift = 0.02;            // m: so far the free sole leaves and meets its faces along their normals; 0: not judged
  double line_tolerance = 5e-4;  // m and rad: how far it may be off that line
};

// Judges `step` after `before`. One foot is placed; the other held in `before` and did not move (1e-9). Forward kinematics from the
// ten sent joints alone gives the placed contact seen from the one that holds, and the base (1e-6 m, 1e-6 rad); the actuators keep
// their limits; the placed plate lies wholly on the face that its contact names; the bodies are free of the scene and of each
// other. If there is a motion: from the joints before to those after, linear in the ten joints between its points, no faster than
// the model's joints, and all this proved over the whole path (see path.hpp). `obstacles` are those of `truss`. Margins: reach (m,
// of an actuator to its limits), clearance and self clearance (m, looked for up to 0.5 m, over the motion as well), plate on face
// (m, from the plate to the face's edge), closure (m, what the contact's error leaves of its tolerance). A refusal is one sentence
// with the values. Any thread.
StepVerdict check_step(const Model& model, const truss::Truss& truss, const Obstacles& obstacles, const CheckOptions& options,
                       const Step& step, const Posture& before);

}  // namespace foothold::hyrecro
