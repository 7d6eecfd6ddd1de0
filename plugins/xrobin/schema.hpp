// The parameters of the Xrobin planner.
#pragma once

#include "foothold/parameters.hpp"

namespace foothold::xrobin {

inline constexpr ParameterSpec kParameters[] = {
    {"method", ParameterKind::kChoice, "", "optimal", 0, 0, "optimal",
     "optimal: the least distance to the goal that the cycles allow, proved"},
    {"cycles", ParameterKind::kInteger, "1", "7", 1, 8, "", "How many cycles are searched at once, at most"},
    {"tolerance", ParameterKind::kReal, "m", "0.001", 1e-6, 1.0, "", "The goal counts as reached within this distance"},
    {"heading_tolerance", ParameterKind::kReal, "rad", "0.0174532925199433", 1e-6, 3.2, "",
     "If the goal has an orientation: how far the heading may be off"},
    {"start_configuration", ParameterKind::kInteger, "1", "1", 1, 8, "",
     "Configuration in which the robot begins, if start gives no contacts"},
};

}  // namespace foothold::xrobin
