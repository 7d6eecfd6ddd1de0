// The parameters of Hex-piderix' planner.
#pragma once

#include "foothold/parameters.hpp"

namespace foothold::hexpiderix {

inline constexpr ParameterSpec kParameters[] = {
    {"method", ParameterKind::kChoice, "", "optimal", 0, 0, "optimal|choice|constant|geometric|emergency",
     "optimal: the posture of greatest stability, proved on a grid; choice: the paper's rule among its three strategies; or one of "
     "them"},
    {"supports", ParameterKind::kChoice, "", "triad1", 0, 0, "triad1|triad2|all",
     "Legs on the ground at the start, where start.contacts does not say it"},
    {"legs", ParameterKind::kChoice, "", "keep", 0, 0, "keep|add|any",
     "optimal: keep the supporting legs; add: one or more may join them; any: the other triad as well"},
    {"places", ParameterKind::kChoice, "", "standing", 0, 0, "standing|any",
     "optimal: legs that join stand where the standing robot has them, or nearer to or farther from the thorax as well"},
    {"share", ParameterKind::kReal, "1", "0.5", 0.0, 1.0, "",
     "geometric: so much of its inclination the thorax turns back (paper: half)"},
    {"friction", ParameterKind::kReal, "1", "100", 0.01, 100.0, "",
     "Between feet and ground; postures that need more are none. The paper knows no friction, so the default demands none"},
    {"clearance", ParameterKind::kReal, "m", "0", 0.0, 0.05, "", "Legs and thorax stay so far from the ground and from each other"},
    {"position_step", ParameterKind::kReal, "m", "0.02", 0.002, 0.06, "", "optimal: of the grid of thorax places"},
    {"tilt_step", ParameterKind::kReal, "rad", "0.2", 0.02, 0.6, "", "optimal: of the grid of roll and pitch"},
    {"yaw", ParameterKind::kReal, "rad", "0", 0.0, 0.5, "",
     "optimal: the thorax may turn so far about the ground's normal, either way"},
    {"lowest", ParameterKind::kReal, "m", "0.02", 0.01, 0.2, "", "optimal: the thorax' least height over the ground"},
    {"stride", ParameterKind::kReal, "m", "0.06", 0.005, 0.12, "", "Walk: so far the thorax moves on in half a cycle, at most"},
    {"turn", ParameterKind::kReal, "rad", "0.15", 0.01, 0.5, "", "Walk: so far the heading turns in half a cycle, at most"},
    {"least_nesm", ParameterKind::kReal, "m", "0.005", 0.0, 0.05, "", "Walk: stability (NESM) at every instant, at least"},
    {"swing", ParameterKind::kReal, "m", "0.03", 0.005, 0.1, "", "Walk: a swinging foot rises so far above what it passes"},
    {"max_boxes", ParameterKind::kInteger, "1", "10000000", 1, 1000000000, "", "optimal: boxes of poses before it gives up"},
    {"snap", ParameterKind::kReal, "m", "0.3", 0.0, 10.0, "",
     "The start may lie so far from the ground; the nearest point is taken"},
};

}  // namespace foothold::hexpiderix
