// Walks of Bioloid to the steps that leave the server.
#pragma once

#include "bioloid/request.hpp"

namespace foothold::bioloid {

// Standing on both soles.
Posture standing_posture(const Model& model, const Feet& feet, const Joints& joints);

// What is wrong with a posture or a motion, in words: "...".
const char* words(Fault fault);

// From the posture given to the one in which a walk begins: no foot is placed.
Step to_step(const Model& model, const Stand& from, const Phase& rise);

// One foot is placed, the `number`th: shift, lift, carry, lower, settle. `joints`: how the robot stands before; they become those
// after.
Step to_step(const Model& model, const Feet& before, Joints& joints, const WalkStep& step, int number);

}  // namespace foothold::bioloid
