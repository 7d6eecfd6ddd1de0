// The paper's A*: Molla-Santamaria et al. 2023, section 5, steps 1 to 3 and equation 4.
//
// Over nodes: each is reached in the one orientation, of four, that costs least from where its predecessor stands (q + e).
// Neighbours not yet explored are looked at again from every node, as in the traditional A* which the paper names (its 104 minutes
// to P_B fit ten neighbours of four orientations for each of 1176 nodes; one look at each would take a tenth). Not optimal on its
// own cost, since the orientation that is kept may be dear later; and an unstable node is only dear (1e12), never forbidden.
#include <algorithm>
#include <limits>

#include "octopod/search/cut.hpp"
#include "octopod/search/open_list.hpp"
#include "octopod/search/route.hpp"

namespace foothold::octopod {
namespace {

constexpr double kPenalty = 1e12;  // e of an unstable posture
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Node {
  double g = kInfinity;
  State state = -1;  // in the orientation that was chosen
  int parent = -1;
  bool explored = false;
};

struct Choice {
  State state = -1;
  double cost = kInfinity;  // q + e
};

// Of the paper's four axes, each with module A at the end that costs less. Those without a posture are passed over: they have no q.
Choice best_orientation(const Ground& ground, State from, int node, const RouteOptions& options) {
  Choice best;
  for (State state = kOrientations * node; state < kOrientations * (node + 1); ++state) {
    if (!ground.stands(state)) continue;
    const double q =
        options.posture_weight * change(ground.standing(from).standing, ground.standing(state).standing, options.weights);
    const double e = options.stability && !allowed(ground, state, options) ? kPenalty : 0.0;
    if (q + e < best.cost) best = {state, q + e};
  }
  return best;
}

// Costs anew, without the penalty, in whose digits they would be lost.
void write_route(const Ground& ground, const std::vector<Node>& nodes, int goal, const RouteOptions& options, Route& out) {
  for (int node = goal; node >= 0; node = nodes[static_cast<std::size_t>(node)].parent)
    out.states.push_back(nodes[static_cast<std::size_t>(node)].state);
  std::reverse(out.states.begin(), out.states.end());
  out.costs.push_back(0.0);
  for (std::size_t k = 1; k < out.states.size(); ++k) {
    out.cost += step_cost(ground, out.states[k - 1], out.states[k], options);
    out.costs.push_back(out.cost);
    if (options.stability && !allowed(ground, out.states[k], options)) ++out.penalised;
  }
}

}  // namespace

Route paper_route(const Ground& ground, State from, int goal_node, const RouteOptions& options, const std::stop_token& stop) {
  const long before = ground.postures_made();
  Route out;
  const Vector3d goal = ground.place(goal_node);
  out.bound = (goal - ground.place(node_of(from))).norm();
  std::vector<Node> nodes(static_cast<std::size_t>(ground.nodes()));
  OpenList open(ground.nodes());
  if (ground.stands(from)) {
    nodes[static_cast<std::size_t>(node_of(from))] = {0.0, from, -1, false};
    open.put(node_of(from), out.bound);
  }
  while (true) {
    if (open.empty()) {
      std::vector<bool> reached(static_cast<std::size_t>(ground.states()));
      for (const Node& node : nodes)
        if (node.explored) reached[static_cast<std::size_t>(node.state)] = true;
      const double bound = out.bound;
      const long expanded = out.expanded;
      RouteOptions careless = options;  // what only stability forbids is dear to it, never forbidden
      careless.stability = false;
      out = blocked(ground, reached, from, goal_node, careless);
      out.bound = bound;
      out.expanded = expanded;
      break;
    }
    if (stop.stop_requested() || out.expanded >= options.max_states) {
      out.end = stop.stop_requested() ? Route::End::kStopped : Route::End::kExhausted;
      break;
    }
    const int current = open.pop();
    Node& self = nodes[static_cast<std::size_t>(current)];
    self.explored = true;
    if (current == goal_node) {
      out.end = Route::End::kFound;
      write_route(ground, nodes, goal_node, options, out);
      break;
    }
    ++out.expanded;
    for (const int neighbour : ground.nearest(current)) {
      Node& other = nodes[static_cast<std::size_t>(neighbour)];
      if (other.explored) continue;
      const Choice choice = best_orientation(ground, self.state, neighbour, options);
      const double d = (ground.place(neighbour) - ground.place(current)).norm(), g = self.g + d + choice.cost;
      if (choice.state < 0 || g >= other.g) continue;
      other = {g, choice.state, current, false};
      open.put(neighbour, g + (goal - ground.place(neighbour)).norm());
    }
  }
  out.postures = ground.postures_made() - before;
  return out;
}

}  // namespace foothold::octopod
