// The parameters of Bioloid's planner.
#pragma once

#include "foothold/parameters.hpp"

namespace foothold::bioloid {

inline constexpr ParameterSpec kParameters[] = {
    {"method", ParameterKind::kChoice, "", "optimal", 0, 0, "optimal|stochastic|random",
     "How single supports are found: optimal (key postures in closed form, lines certified, search where they fail), or the "
     "paper's "
     "stochastic or fully random algorithm"},
    {"trials", ParameterKind::kInteger, "1", "1", 1, 1000, "", "Of the paper's methods: trials of each single support"},
    {"choose", ParameterKind::kChoice, "", "iterations", 0, 0, "iterations|error|variance",
     "Of the trials, the one with the fewest iterations, the least mean error or the least variance of the error"},
    {"iterations", ParameterKind::kInteger, "1", "100000", 100, 10000000, "", "Of the paper's methods: at most, in one trial"},
    {"step_length", ParameterKind::kReal, "m", "0.05", 0.005, 0.08, "",
     "A foot goes so far ahead of the standing one, at most (paper: 50 mm)"},
    {"step_back", ParameterKind::kReal, "m", "0.03", 0.005, 0.06, "", "A foot goes so far behind the standing one, at most"},
    {"step_width", ParameterKind::kReal, "m", "0.03", 0.005, 0.06, "",
     "A foot goes so much farther out than side by side, at most"},
    {"turn", ParameterKind::kReal, "rad", "0.2618", 0.0, 0.79, "",
     "A foot turns so far against the standing one, at most; beyond 15 deg fewer steps are found, but seldom proved least"},
    {"lift", ParameterKind::kReal, "m", "0.010", 0.005, 0.04, "", "The moving sole is lifted so high (paper: 10 mm)"},
    {"step_over", ParameterKind::kReal, "m", "0.02", 0.0, 0.04, "", "Feet may pass over obstacles up to this height"},
    {"height", ParameterKind::kReal, "m", "0.12", 0.09, 0.148, "", "Of the hips over the ankles while walking"},
    {"balance", ParameterKind::kReal, "m", "0.010", 0.0, 0.028, "",
     "The centre of mass stays so far inside the soles that stand, at every instant"},
    {"clearance", ParameterKind::kReal, "m", "0.002", 0.0, 0.015, "",
     "Bodies stay so far from each other and from obstacles, at every instant"},
    {"pace", ParameterKind::kReal, "1", "0.2", 0.01, 1.0, "", "Share of the servos' speed without load that a motion may take"},
    {"period", ParameterKind::kReal, "s", "0.02", 0.002, 0.1, "", "Between two samples for the servo bus, at most"},
    {"cell", ParameterKind::kReal, "m", "0.01", 0.0025, 0.02, "", "Of the lattice of footsteps; headings are 15 deg apart"},
    {"proof_nodes", ParameterKind::kInteger, "1", "5000", 0, 400000, "",
     "So many footsteps are looked at to prove that a route is least; where that is too few, lower_bound says what was proved"},
};

}  // namespace foothold::bioloid
