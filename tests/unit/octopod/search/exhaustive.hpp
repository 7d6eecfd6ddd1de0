// Least costs by looking at everything: all postures, all edges, Bellman and Ford's rounds until nothing changes.
#pragma once

#include <limits>
#include <vector>

#include "octopod/search/route.hpp"

namespace foothold::octopod {

// By state, m; infinity where no way leads.
inline std::vector<double> least_costs(const Ground& ground, State from, const RouteOptions& options, const Edge& edge) {
  const auto allowed = [&](State state) { return options.stability ? ground.stable(state) : ground.stands(state); };
  struct Arc {
    State from, to;
    double cost;
  };
  std::vector<Arc> arcs;
  for (State a = 0; a < ground.states(); ++a) {
    if (!allowed(a)) continue;
    for (const int node : ground.adjacent(node_of(a)))
      for (State b = kOrientations * node; b < kOrientations * (node + 1); ++b)
        if (allowed(b) && (!edge || edge(a, b))) arcs.push_back({a, b, step_cost(ground, a, b, options)});
  }
  std::vector<double> out(static_cast<std::size_t>(ground.states()), std::numeric_limits<double>::infinity());
  if (!allowed(from)) return out;
  out[static_cast<std::size_t>(from)] = 0.0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Arc& arc : arcs) {
      const double over = out[static_cast<std::size_t>(arc.from)] + arc.cost;
      double& least = out[static_cast<std::size_t>(arc.to)];
      if (over < least) {
        least = over;
        changed = true;
      }
    }
  }
  return out;
}

}  // namespace foothold::octopod
