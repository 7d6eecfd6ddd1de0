// The parameters of the Xrobin planner.
#pragma once

#include "foothold/parameters.hpp"

namespace foothold::xrobin {

inline constexpr ParameterSpec kParameters[] = {
    {"method", ParameterKind::kChoice, "", "optimal", 0, 0, "optimal|fewest|greedy|brute_force",
     "optimal: least distance to the goal, proved; fewest: least cycles that meet the tolerance, proved; greedy: the paper's; "
     "brute_force: every word, 4 cycles at most"},
    {"cycles", ParameterKind::kInteger, "1", "7", 1, 8, "", "How many cycles are searched at once, at most"},
    {"max_cycles", ParameterKind::kInteger, "1", "70", 1, 1000, "",
     "How long the whole plan may be when the goal cannot be met with `cycles`"},
    {"tolerance", ParameterKind::kReal, "m", "0.001", 1e-6, 1.0, "", "The goal counts as reached within this distance"},
    {"heading_tolerance", ParameterKind::kReal, "rad", "0.0174532925199433", 1e-6, 3.2, "",
     "If the goal has an orientation: how far the heading may be off"},
    {"start_configuration", ParameterKind::kInteger, "1", "1", 1, 8, "",
     "Configuration in which the robot begins, if the start gives no contacts"},
    {"grid_cells", ParameterKind::kInteger, "1", "201", 11, 1001, "", "greedy: cells along a side of the density grids"},
    {"early_stop", ParameterKind::kFlag, "", "true", 0, 0, "", "greedy: leave out cycles that bring the robot no nearer"},
    {"clearance", ParameterKind::kReal, "m", "0.001", 0.0, 0.1, "",
     "With a scene: bodies and pistons stay at least so far away from obstacles, at rest and on the way"},
    {"max_pairs", ParameterKind::kInteger, "1", "1000000", 1, 1000000000, "",
     "With a scene: how many pairs of half plans the exact search looks at before it gives up"},
    {"max_nodes", ParameterKind::kInteger, "1", "20000", 1, 10000000, "",
     "With a scene: how many stances are looked at on the way to a far goal"},
};

}  // namespace foothold::xrobin
