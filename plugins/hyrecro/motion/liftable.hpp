// Can a foot be lifted at all from where it stands? What a stride needs beyond a posture on its footholds.
#pragma once

#include "hyrecro/reach/reachability.hpp"

namespace foothold::hyrecro {

// With both soles where `free_in_holding` has them, the free one (the one that holds) can stand `height` (m) above its place along
// its own normal without turning. Necessary for any motion that sets the free foot down there, or lifts it; respectively for the
// next stride, which lifts the foot that holds. At the border of the workspace, where searches for few strides like to be, it often
// cannot. By `exact`, so a no is proved; the scene is not looked at. Thread rule of Reachability.
bool free_foot_liftable(Reachability& exact, const Isometry3d& free_in_holding, double height);
bool holding_foot_liftable(Reachability& exact, const Isometry3d& free_in_holding, double height);

}  // namespace foothold::hyrecro
