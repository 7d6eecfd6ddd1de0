// Why no route leads to the goal: which faces can be entered, and what keeps the robot from the goal's.
#pragma once

#include "hyrecro/optimal/truss_graph.hpp"

namespace foothold::hyrecro {

// To be asked after a search without result. Enters face by face from the start, each by the first transition that works; then
// looks for the transition to the goal's face that comes nearest to working. Takes some milliseconds, more on large trusses.
Failure why_unreachable(TrussGraph& graph, const PreparedTruss& scene, KeptTruss& kept, const std::stop_token& stop);

// No stride leads away from `at`, which is the request's `field`, start or goal.
Failure hemmed_in(const PreparedTruss& scene, const Foothold& at, const std::string& field);

}  // namespace foothold::hyrecro
