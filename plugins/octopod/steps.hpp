// States of a route to the steps that leave the server.
#pragma once

#include "octopod/search/ground.hpp"
#include "octopod/transition/transition.hpp"

namespace foothold::octopod {

// The posture over a node with its eight contacts: +Z is the terrain's normal, +X the module's axis laid into the terrain.
// Precondition: a posture stands there. Any thread.
Posture standing_posture(const Standing& standing);

// The step that brings the robot to `state`, without its motion. `cost`: m, of the plan up to there. Any thread.
Step to_step(const Ground& ground, State state, double cost);
// The step to a stop on the way to `state`, likewise.
Step to_stop(const Ground& ground, const Standing& stop, State state, double cost);

}  // namespace foothold::octopod
