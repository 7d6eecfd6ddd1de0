// The search on large scenes: a good route soon, not the best one.
//
// Ways from cell to cell (portals.hpp) are looked for by A*; what the best one needs is evaluated then, and what fails leaves the
// graph or costs more from then on, until a way holds (Dellin and Srinivasa 2016, lazy shortest path). On a way the footholds are
// chosen depth first, transition by transition.
#pragma once

#include "hyrecro/optimal/truss_graph.hpp"

namespace foothold::hyrecro {

// `graph` must be of a large scene. Its bound is what the straight distance demands. kLimit where no way held after many, and where
// cells do not lead to the goal at all: that proves nothing.
SearchResult search_large(TrussGraph& graph, const Portals& portals, const std::stop_token& stop);

}  // namespace foothold::hyrecro
