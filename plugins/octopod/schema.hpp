// The parameters of the octopod's planner.
#pragma once

#include "foothold/parameters.hpp"

namespace foothold::octopod {

inline constexpr ParameterSpec kParameters[] = {
    {"method", ParameterKind::kChoice, "", "optimal", 0, 0, "optimal|paper|rrt",
     "optimal: least cost over nodes and orientations, proved; paper: A* over nodes as printed; rrt: RRT* over the surface"},
    {"stability", ParameterKind::kFlag, "", "true", 0, 0, "",
     "Unstable stances are forbidden (paper: dear); if false they are as good as others, and the plan is not safe"},
    {"transitions", ParameterKind::kFlag, "", "false", 0, 0, "",
     "Only from stance to stance where legs can be moved one after the other in equilibrium; each step carries that motion. Takes "
     "longer, and a finer resolution where stances are far apart"},
    {"friction", ParameterKind::kReal, "1", "0.4", 0.01, 10.0, "", "Coefficient between feet and terrain"},
    {"node_slope", ParameterKind::kReal, "rad", "1.57", 0.0, 1.57, "",
     "With stability: over steeper ground than this the robot does not stand, even where it is held with its feet braced across; "
     "0: as "
     "steep as friction holds on a plane"},
    {"cone_edges", ParameterKind::kInteger, "1", "10", 0, 256, "",
     "Edges of the pyramid inscribed in a friction cone, 3 at least; 0: the exact cone"},
    {"posture_weight", ParameterKind::kReal, "1", "1", 0.0, 1000.0, "", "Of the change of posture (q) beside the way (d)"},
    {"place_weight", ParameterKind::kReal, "1", "1", 0.0, 1000.0, "", "In q: of the bodies' places"},
    {"orientation_weight", ParameterKind::kReal, "m/rad", "0.1", 0.0, 1000.0, "", "In q: of the bodies' orientations"},
    {"joint_weight", ParameterKind::kReal, "m/rad", "0.01", 0.0, 1000.0, "", "In q: of the legs' joints"},
    {"resolution", ParameterKind::kReal, "m", "0.2", 0.005, 10.0, "",
     "The terrain's triangles are divided below this circumradius"},
    {"split", ParameterKind::kChoice, "", "midpoint", 0, 0, "midpoint|slivers|longest_side",
     "How triangles are divided: 1 to 4 (paper), the same but slivers at their longest side, or all at their longest side"},
    {"neighbours", ParameterKind::kInteger, "1", "10", 1, 64, "",
     "Nearest nodes that a node is joined with, beside (optimal, rrt) those across its triangle's edges"},
    {"clearance", ParameterKind::kReal, "m", "0", 0.0, 0.1, "", "Bodies and legs stay so far above the terrain"},
    {"swing_height", ParameterKind::kReal, "m", "0.04", 0.005, 0.2, "",
     "transitions: a swinging foot rises so far; over obstacles up to three times as far"},
    {"snap", ParameterKind::kReal, "m", "0.1", 0.0, 10.0, "",
     "Start and goal may lie so far from the terrain; the node nearest to them is taken"},
    {"samples", ParameterKind::kInteger, "1", "20000", 1, 100000000, "", "rrt: so many are drawn"},
    {"max_states", ParameterKind::kInteger, "1", "100000000", 1, 1000000000, "", "States that a search expands before it gives up"},
};

}  // namespace foothold::octopod
