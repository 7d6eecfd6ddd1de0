// Where a route may go.
#include <cmath>

#include "octopod/search/route.hpp"

namespace foothold::octopod {

bool allowed(const Ground& ground, State state, const RouteOptions& options) {
  if (!options.stability) return ground.stands(state);
  return ground.slope(node_of(state)) <= options.steepest && ground.stable(state);
}

// A pyramid's faces lie inside the cone by the cosine of half the angle between two of its edges.
double steepest_held(double friction, int cone_edges) {
  return std::atan(cone_edges == 0 ? friction : friction * std::cos(std::numbers::pi / cone_edges));
}

}  // namespace foothold::octopod
