// `method: optimal`: the least number of strides over the whole route, proved; or the least way of the feet.
//
// Set of routes: any transition between the scene's sampled transition footholds, start and goal; any footholds between them on a
// face. On large scenes (kLarge) a good route is looked for instead of the best, as `objective` says.
#pragma once

#include "hyrecro/scene/prepared.hpp"

namespace foothold::hyrecro {

struct OptimalOptions {
  Objective objective = Objective::kSteps;
  std::size_t max_nodes = 1'000'000;  // of the search, before it gives up (NODE_LIMIT)
  // m: from every stance both feet must have room to rise so far along their normals, as motions do (see Strides); 0: need not.
  double lift = 0.0;
  std::vector<Ban> banned;  // few; holds for this call alone. A proof is then one among the routes without them
};

// Never more strides than plan_paper() with exact reachability on the same scene, unless that is large. Used by one thread at a
// time.
Found plan_optimal(const Model& model, const PreparedTruss& scene, const Foothold& start, const Foothold& goal,
                   const OptimalOptions& options, const std::stop_token& stop, const OnStride& on_stride);

}  // namespace foothold::hyrecro
