// What a plan of the octopod says of its quality, or why there is none.
#pragma once

#include "octopod/request.hpp"

namespace foothold::octopod {

// Beside the route.
struct Course {
  double goal_distance = 0.0;  // m, from the asked place to the last node
  double search_time = 0.0;    // ms
  double motion_time = 0.0;    // ms
  double least_margin = 0.0;   // 1, friction left over all stances of the motions; with transitions only
};

// Of a route that was found and sent. Any thread that may use `ground`.
PlanReport found_report(const Ground& ground, const Options& options, const Route& route, const Course& course);
// Why there is none to the node `goal`: the cut, or the limit that was met.
PlanReport failed_report(const Options& options, const Route& route, int goal);

}  // namespace foothold::octopod
