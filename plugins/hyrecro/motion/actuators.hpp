// The ten actuators as a vector: what a motion is linear in between two points.
#pragma once

#include <Eigen/Core>

#include "hyrecro/model/chain.hpp"

namespace foothold::hyrecro {

// Lengths l1, r1, l2, r2 of leg 0 and of leg 1 (m), then both hip angles (rad, not wrapped). "0" is the foot that holds.
using Actuators = Eigen::Matrix<double, 10, 1>;

// Any thread.
Actuators to_actuators(const Model& model, const Coordinates& coordinates);
// Precondition: lengths within the limits by 1e-6 m.
Coordinates from_actuators(const Model& model, const Actuators& actuators);

// What the straight way between two postures takes, s: the slowest actuator at its greatest speed.
double duration(const Model& model, const Actuators& a, const Actuators& b);

// `to` with both hip angles changed by whole turns until they are within half a turn of those of `from`.
Actuators with_nearest_turns(const Actuators& from, const Actuators& to);

}  // namespace foothold::hyrecro
