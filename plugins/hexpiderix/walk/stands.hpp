// Thorax poses over given footholds, the usual one first. Any thread.
#pragma once

#include <functional>

#include "hexpiderix/walk/instant.hpp"

namespace foothold::hexpiderix {

// Calls `take` with stands in which both tripods have a NESM of at least `options.least_nesm` and nothing is in the way, until it
// returns true: thorax over the plane under the station, at some heights, shifted uphill, parallel to the plane or turned back
// towards the level; those first that leave the legs the most room. Returns whether `take` did. `because`: of the last refusal.
bool any_stand(const Model& model, const Ground& ground, const Station& station, const Plane& plane, const Footholds& feet,
               const WalkOptions& options, std::string& because, const std::function<bool(const Stand&)>& take);

}  // namespace foothold::hexpiderix
