// The parameters of the HyReCRo planner.
#pragma once

#include "foothold/parameters.hpp"

namespace foothold::hyrecro {

inline constexpr ParameterSpec kParameters[] = {
    {"method", ParameterKind::kChoice, "", "optimal", 0, 0, "optimal|paper",
     "optimal: least steps or way over the whole route, proved; paper: transitions first, then each face by itself"},
    {"objective", ParameterKind::kChoice, "", "steps", 0, 0, "steps|distance", "optimal: what is least, ties by the other"},
    {"reachability", ParameterKind::kChoice, "", "exact", 0, 0, "exact|network|iterative",
     "paper: how a foothold is found reachable: in closed form, by two perceptrons, or by random tries; optimal takes exact alone"},
    {"motion", ParameterKind::kFlag, "", "true", 0, 0, "", "Each step carries the actuators' path from one stance to the next"},
    {"clearance", ParameterKind::kReal, "m", "0.005", 0.0, 0.05, "",
     "Legs and hip stay so far away from the truss, and the robot's bodies from each other"},
    {"d_cncv", ParameterKind::kReal, "m", "0.25", 0.05, 1.0, "",
     "How far from the line in which two beams' faces meet a foot stands to change between them"},
    {"d_cnvx", ParameterKind::kReal, "m", "0.07", 0.05, 0.5, "",
     "How far from an edge of a beam a foot stands to go round it; paper: also how far the way on a face keeps from its edges"},
    {"transition_step", ParameterKind::kReal, "m", "0.05", 0.005, 1.0, "", "Between transition footholds along an edge"},
    {"position_step", ParameterKind::kReal, "m", "0.01", 0.005, 0.05, "", "Of the planar workspace"},
    {"heading_step", ParameterKind::kReal, "rad", "0.0872664625997165", 0.0174, 1.6, "",
     "Of the planar workspace; a whole number of them makes a turn"},
    {"face_rule", ParameterKind::kChoice, "", "paper", 0, 0, "paper|zhu",
     "paper: the next foothold by the paper's algorithms 1 and 2, or by the rule of Zhu et al. 2020"},
    {"face_way", ParameterKind::kChoice, "", "visibility", 0, 0, "visibility|grid",
     "paper: the way on a face by a visibility graph, or by the A* of Zhu et al. on a grid of 0.1 m"},
    {"least_dot", ParameterKind::kReal, "1", "0.998", 0.5, 1.0, "",
     "paper: cosine of how far a foothold's heading may be off the best one"},
    {"tries", ParameterKind::kInteger, "1", "300", 1, 1000000, "", "iterative: random postures tried for each foothold"},
    {"lift", ParameterKind::kReal, "m", "0.02", 0.0, 0.1, "", "motion: so far a foot leaves and meets its face along the normal"},
    {"max_nodes", ParameterKind::kInteger, "1", "1000000", 1, 1000000000, "",
     "optimal: nodes that the search expands before it gives up"},
};

}  // namespace foothold::hyrecro
