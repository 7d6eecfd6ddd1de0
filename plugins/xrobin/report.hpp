// What a plan of Xrobin says of its quality.
#pragma once

#include "foothold/planner.hpp"
#include "solver.hpp"

namespace foothold::xrobin {

// Cost, lower bound, objective and outcome of a solution by `method`.
PlanReport report_of(Method method, const Target& goal, const Limits& limits, const Mechanism& mechanism, const Solution& solution);

}  // namespace foothold::xrobin
