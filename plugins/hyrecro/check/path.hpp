// Judges the motion of a step over the whole path, not at samples.
#pragma once

#include "hyrecro/check/clear.hpp"
#include "hyrecro/check/stances.hpp"

namespace foothold::hyrecro {

// The motion begins at the joints before and ends at those after (1e-9; hip angles may differ by whole turns), its times grow, each
// point's base is where its joints put it, no joint is faster than the model's, the actuators keep their limits (a straight piece
// between two postures within them does as well). At its begin the free foot is at its old contact.
//
// Between the points the joints are linear. The path is halved until at the middle of every part each body is farther from what it
// must not meet than it can move within that part (rates.hpp): a proof for all postures between. It fails where a middle comes
// nearer than the clearance; what lies between two middles is proved to kProof less than the clearance (half of it, if less), and
// that plates do not overlap the scene by kProof.
//
// For the first (last) `lift` metres over its old (new) face the free sole keeps to that contact's normal: neither aside nor turned
// by more than the tolerance, proved in the same way to half of it more.
//
// Returns the actuators' least distance from their limits, m; lowers `least`. Throws Refusal. Any thread.
double judge_path(const Setting& setting, const Stances& stances, const Step& step, const Posture& before, Clearance& least);

}  // namespace foothold::hyrecro
