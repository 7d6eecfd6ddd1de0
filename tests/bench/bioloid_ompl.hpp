// OMPL's planners on single supports, in the nine free joints, with the same judge of postures and of lines as ours.
#pragma once

#include "bioloid_phases.hpp"

namespace foothold::bench {

enum class OmplPlanner { kRrtConnect, kLbkpiece };

// The path that was found, empty if none within `seconds` of CPU time; only exact solutions count. `simplified`: OMPL's
// simplification afterwards, for a millisecond at most. `spent`: CPU time, s, without setting up the space.
std::vector<bioloid::Free> solve_by_ompl(const bioloid::Model& model, const SinglePhase& phase, OmplPlanner planner, double seconds,
                                         bool simplified, double& spent);

// OMPL's random numbers are the process': once, before anything else of OMPL.
void seed_ompl(std::uint_fast32_t seed);

}  // namespace foothold::bench
