// How far it is to the goal over the nodes alone: what every route must cost at least.
#pragma once

#include <vector>

#include "octopod/search/ground.hpp"

namespace foothold::octopod {

// By node: least sum of d to the goal along Ground::adjacent() over nodes no steeper than `steepest` (rad), m; infinity where there
// is no way. Dijkstra from the goal.
std::vector<double> distances_to(const Ground& ground, int goal_node, double steepest);

}  // namespace foothold::octopod
