// How far the bodies move at most while the actuators move straight from one posture to another: what turns distances at single
// postures into a proof for all between them.
#pragma once

#include "hyrecro/motion/actuators.hpp"

namespace foothold::hyrecro {

// Bounds, m: no point of the body is ever farther from where it is at the middle of the way. Infinite where no bound was found.
struct Sweep {
  double leg0 = 0.0, hip = 0.0, leg1 = 0.0, plate1 = 0.0;  // in the frame of the sole that holds (plate 0 stays)
  double plate1_about_hip = 0.0;                           // seen from the hip plate
  double legs = 0.0;                                       // of either leg towards the other
};

// `middle` is from_actuators() of the mean of `a` and `b`. The mechanisms' velocities are enclosed by interval arithmetic over the
// way (l dl +- r dr is linear in the way's parameter; phi and y by enclosures that prove themselves), then carried along the chain
// from the sole that holds. Grows linearly with the way; some per cent above the truth for short ways that one joint makes. Any
// thread.
Sweep sweep(const Model& model, const Actuators& a, const Actuators& b, const Coordinates& middle);

}  // namespace foothold::hyrecro
