// Why there is no way: the states that separate the start from the goal.
#pragma once

#include "octopod/search/route.hpp"

namespace foothold::octopod {

// `reached`, by state: whether the search went through it. The cut is made of those states beside reached ones from which the goal
// can be had without meeting reached ones or others of the cut, if posture and equilibrium are no matter: whoever goes from start
// to goal goes through one of them. Nearest to the goal first (m, straight).
std::vector<State> cut(const Ground& ground, const std::vector<bool>& reached, int goal_node);

// The answer of a search that reached all it could. Where the start or the goal itself will not do, that is the cut.
Route blocked(const Ground& ground, const std::vector<bool>& reached, State from, int goal_node, const RouteOptions& options);

// What a state lacks: "(0.31, 0.52, -0.33), slope 33.1 deg: needs friction 0.65, has 0.40".
std::string describe_state(const Ground& ground, State state, const RouteOptions& options);

}  // namespace foothold::octopod
