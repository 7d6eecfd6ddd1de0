// Why no route leads to the goal: which face cannot be entered, its nearest transition, and what blocks that.
#pragma once

#include <span>

#include "hyrecro/reach/reachability.hpp"
#include "hyrecro/scene/prepared.hpp"

namespace foothold::hyrecro {

// `reached`: the footholds that a search came to before it ran out, start included. The failure speaks of the goal's face and of
// the pair of footholds that is nearest to spanning the gap; at most some fifty pairs are asked of `exact`. Used by one thread at a
// time.
Failure explain_unreachable(const Model& model, const PreparedTruss& scene, Reachability& exact, std::span<const Foothold> reached,
                            const Foothold& goal, double greatest_reach);

}  // namespace foothold::hyrecro
