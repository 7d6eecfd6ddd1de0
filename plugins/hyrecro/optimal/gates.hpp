// Strides round a foothold that hardly any lead to: where beams stand so near that few postures fit, or where its face has room for
// one plate alone.
//
// A lattice of footholds misses them: under a low beam only the very lowest postures fit, and the footholds that these reach are
// a thin set. So the postures of a stride within the face are sampled themselves: heights from the lowest to the highest, shifts of
// the leg that stands there, direction of the hip plate; where leg and hip are free so far, the other leg's shifts and headings.
// On other faces any foothold may do, not the sampled ones alone: a lattice, sifted by ReachFilter, judged by exact reachability.
#pragma once

#include <stop_token>
#include <vector>

#include "hyrecro/optimal/legs.hpp"
#include "hyrecro/reach/reach_filter.hpp"

namespace foothold::hyrecro {

// Strides from `end` to footholds apart from each other, each of which has strides of its own; none that is `banned`. Few, and
// always the same. Milliseconds on its own face, tenths of a second with other faces, which are looked at if its own gives none.
std::vector<Stride> gates(Strides& strides, Legs& legs, const ReachFilter& filter, const Foothold& end, const Banned& banned,
                          const std::stop_token& stop);

}  // namespace foothold::hyrecro
