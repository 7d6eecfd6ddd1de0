// Where feet can stand near where the standing robot would have them. Any thread.
#pragma once

#include "hexpiderix/walk/walk.hpp"

namespace foothold::hexpiderix {

// The plane of least squares through the ground under the six feet of a robot standing at the station; its point lies under the
// station. Empty if there is no ground under a foot.
std::optional<Plane> plane_at(const Model& model, const Ground& ground, const Station& station);

// Six footholds at a station, each the nearest to its standing place that may carry: ground, and not steeper against the plane of
// the station than friction allows. Empty with the leg that finds none.
std::optional<Footholds> footholds_at(const Model& model, const Ground& ground, const Station& station, const Plane& plane,
                                      double friction, std::size_t& leg);

}  // namespace foothold::hexpiderix
