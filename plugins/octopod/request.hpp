// What a request asks of the octopod: parameters, start and goal, judged and converted.
#pragma once

#include "foothold/planner.hpp"
#include "octopod/check/check.hpp"
#include "octopod/search/route.hpp"

namespace foothold::octopod {

enum class Method { kOptimal, kPaper, kRrt };

struct Options {
  Method method = Method::kOptimal;
  bool transitions = true;
  double swing_height = 0.0;  // m
  double snap = 0.0;          // m
  GroundOptions ground;
  RouteOptions route;
};

// Throws InvalidRequest for combinations that make no sense, with the parameter at fault.
Options read_options(const Parameters& parameters);
// What check() needs of them.
CheckOptions check_options(const Options& options);

// The state in which the robot begins. `start.base` lies on the terrain under C (the paper's P_O), no farther from it than
// options.snap. Its X axis chooses among the headings over the nearest node; with any_orientation the robot looks towards the goal
// as well as it can stand. Throws InvalidRequest: nothing or something else given, off the terrain, no posture, unstable (unless
// stability is off).
State read_start(const Ground& ground, const Options& options, const Request& request);

// The node nearest to `goal.base`, in any orientation. Throws InvalidRequest as above, but not for what stands in the way there:
// that is the search's to find.
int read_goal(const Ground& ground, const Options& options, const Placement& goal);

}  // namespace foothold::octopod
