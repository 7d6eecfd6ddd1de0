// What a request asks of Xrobin: start and goal in the plane, judged and converted.
#pragma once

#include "foothold/planner.hpp"
#include "pair_search.hpp"
#include "route.hpp"

namespace foothold::xrobin {

// Throws InvalidRequest with the field at fault.
Stance read_start(const Mechanism& mechanism, const Placement& start, const Parameters& parameters);

// The goal of body A in the world. Throws InvalidRequest with the field at fault.
Target read_goal(const Placement& goal, const Parameters& parameters);

}  // namespace foothold::xrobin
