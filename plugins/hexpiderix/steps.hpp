// Postures of Hex-piderix to the steps that leave the server.
#pragma once

#include "hexpiderix/adapt/adapt.hpp"
#include "hexpiderix/request.hpp"

namespace foothold::hexpiderix {

// The posture with its supporting contacts: +Z is the ground's normal, +X the thorax' heading laid into the ground.
Posture standing_posture(const Coordinates& at, const Footholds& footholds);

// From the start to the adapted posture: first the legs that join come down, then the thorax moves on straight lines (places and
// rotations), supporting feet fast. Empty if a leg does not reach all the way. Times within the joints' speed.
std::vector<MotionPoint> adapting_motion(const Model& model, const Start& from, const Adaption& to);

Step to_step(const Model& model, const Start& from, const Adaption& to);

// Half a cycle of a walk, the `number`th: the three feet that swing are placed. Times within the joints' speed. `cost`: m, of the
// way up to there.
Step to_step(const Model& model, const Stand& from, const HalfCycle& half_cycle, int number, double cost);

}  // namespace foothold::hexpiderix
