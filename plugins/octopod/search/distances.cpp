// Dijkstra over the nodes, backwards from the goal.
#include "octopod/search/distances.hpp"

#include <limits>

#include "octopod/search/open_list.hpp"

namespace foothold::octopod {

std::vector<double> distances_to(const Ground& ground, int goal_node) {
  std::vector<double> out(static_cast<std::size_t>(ground.nodes()), std::numeric_limits<double>::infinity());
  OpenList open(ground.nodes());
  out[static_cast<std::size_t>(goal_node)] = 0.0;
  open.put(goal_node, 0.0);
  while (!open.empty()) {
    const int node = open.pop();
    const double far = out[static_cast<std::size_t>(node)];
    for (const int other : ground.adjacent(node)) {
      const double over = far + (ground.place(other) - ground.place(node)).norm();
      double& least = out[static_cast<std::size_t>(other)];
      if (over >= least) continue;
      least = over;
      open.put(other, over);
    }
  }
  return out;
}

}  // namespace foothold::octopod
