// Judges a step of Bioloid on level ground (Z = 0) from the joints that are sent, the contacts and the obstacles alone: nothing of
// the search's.
#pragma once

#include <span>

#include "bioloid/model/model.hpp"
#include "bioloid/prism.hpp"

namespace foothold::bioloid {

struct CheckOptions {
  double clearance = 0.002;  // m, between bodies that are not neighbours, and to obstacles
  double balance = 0.010;    // m, of the projected centre of mass inside the support polygon
  double ground = 2e-4;      // m, by which a sole on its way may be lower than the ground
  double slip = 2e-4;        // m and rad, by which a standing sole may be off its contact during the motion
  double speed = 1.0;        // of the servos' speeds, at most
};

// Judges `step` after `before`. One foot is placed at most; what stood before and was not placed stands after where it stood
// (1e-9), but a foot may be taken up: then `after.stance` is without it. Contacts lie on the ground, Z up. Both postures' joints
// keep their limits and bring every standing sole to its contact (1e-6 m and rad), and the base is what the foot that stands all
// along and the joints say, there and at each point of the motion (1e-6). The motion begins at `before` and ends at `step.after`
// (1e-9), its times grow from 0, and no servo is faster than `speed`. It is linear in the joints between its points, and the
// following is proved all along these lines, by screws and bounds on their motion: the foot that moves stands within `slip` of its
// old or new contact or is on its way, then its sole is above the ground (at the points) and never lower than -`ground`; bodies
// keep `clearance` among themselves and from obstacles, none but feet and what stands on their plates reaches the ground; the
// centre of mass stays `balance` inside the soles' hull. Distances are proved to 1e-5 m, all else to 1e-6. The other foot is what
// the robot is seen from.
//
// Margins: clearance (m, looked for up to 0.1 m), balance (m), limits (rad), speed (share of the servos' speed left), slip (m and
// rad: what is left of the tolerance; if a second sole stands), ground (m, of the moving foot's lowest corner) and lift (m, the
// most that corner gets above the ground; both if a foot moves). A refusal is one sentence with the values. Any thread.
StepVerdict check_step(const Model& model, std::span<const Prism> obstacles, const Step& step, const Posture& before,
                       const CheckOptions& options);

}  // namespace foothold::bioloid
