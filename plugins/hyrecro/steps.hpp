// Strides to the steps that leave the server.
#pragma once

#include "hyrecro/motion/motion.hpp"
#include "hyrecro/posture.hpp"
#include "hyrecro/request.hpp"

namespace foothold::hyrecro {

// How a stride changes faces.
enum class Change { kNone, kConvex, kConcave };
// Convex: the new foothold does not lie in front of the old one's plane. Any thread.
Change change_of(const truss::Truss& truss, const Foothold& from, const Foothold& to);
const char* name_of(Change change);  // "none", "convex", "concave"

// The step of one stride without its motion: `holding` holds, the other foot is put to `stride.to`. `cost`: of the plan so far.
// Any thread.
Step to_step(const Model& model, const truss::Truss& truss, const Grip& holding, const Stride& stride, double cost);

// Gives `step` its motion. `before`: the joints of the posture before it, from which the hips' angles go on without a jump; they
// end in `step.after`. Any thread.
void add_motion(const Model& model, const truss::Truss& truss, const Grip& holding, const Motion& motion,
                const std::vector<double>& before, Step& step);

// The contact of a grip: limb, world frame, face. Any thread.
Contact to_contact(const truss::Truss& truss, const Grip& grip);

}  // namespace foothold::hyrecro
