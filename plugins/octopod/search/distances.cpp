// Dijkstra over the nodes, backwards from the goal.
#include "octopod/search/distances.hpp"

#include <limits>

#include "octopod/search/open_list.hpp"

namespace foothold::octopod {

std::vector<double> distances_to(const Ground& ground, int goal_node, double steepest) {
  std::vector<double> out(static_cast<std::size_t>(ground.nodes()), std::numeric_limits<double>::infinity());
  OpenList open(ground.nodes());
  out[static_cast<std::size_t>(goal_node)] = 0.0;
  open.put(goal_node, 0.0);
  while (!open.empty()) {
    const int node = open.pop();
    const double far = out[static_cast<std::size_t>(node)];
    const auto beside = ground.adjacent(node);
    const auto lengths = ground.lengths(node);
    for (std::size_t k = 0; k < beside.size(); ++k) {
      const double over = far + lengths[k];
      double& least = out[static_cast<std::size_t>(beside[k])];
      if (over >= least || ground.slope(beside[k]) > steepest) continue;
      least = over;
      open.put(beside[k], over);
    }
  }
  return out;
}

}  // namespace foothold::octopod
