// The perceptrons that are shipped with the planner, for tests, benches and the training program; the planner's way in is
// make_network() in reachability.hpp.
#pragma once

#include "hyrecro/reach/poses.hpp"

namespace foothold::hyrecro {

// As plugins/hyrecro/reach/weights/<kind>.txt was when this was built; read once. Throws std::runtime_error if that file is broken.
// Any thread.
const TrainedPerceptron& shipped_perceptron(PoseKind kind);

}  // namespace foothold::hyrecro
