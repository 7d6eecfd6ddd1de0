// Where a sole may stand among obstacles, and how high it has to be lifted to get there.
//
// Metres, world frame, ground at z = 0. Values; any thread.
#pragma once

#include <span>

#include "bioloid/gait/planar.hpp"
#include "bioloid/posture/judge.hpp"

namespace foothold::bioloid {

// A sole's outline at a place, grown by `margin`; counter-clockwise.
geometry::Polygon footprint(const Model& model, const PlanarPose& sole, double margin);

// The prism that a sole at `sole` would stand on or be nearer to than `clearance`; null if none.
const Prism* stands_on(const Model& model, const PlanarPose& sole, std::span<const Prism> prisms, double clearance);

// Height of the highest prism nearer than `clearance` to what a sole sweeps between two places (the convex hull of both
// footprints); 0 if none.
double highest_between(const Model& model, const PlanarPose& from, const PlanarPose& to, std::span<const Prism> prisms,
                       double clearance);

}  // namespace foothold::bioloid
