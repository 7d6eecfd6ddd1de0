// How far a leg's first and last strides lead along a narrow face, to the millimetre: bounds that know what the foothold between
// must fulfil, proved by branch and bound.
//
// The foothold at the other end of a stride lies in the strip with its whole plate, the less aside the more it is turned. Its place
// across and its heading are cut into cells, and StrideBounds::advance() bounds what leads to each; where two strides meet in one
// foothold, both must reach the same cell. Values; any thread.
#pragma once

#include "hyrecro/optimal/bounds.hpp"

namespace foothold::hyrecro {

// What the paces of one stride from `from` along the strip come to at most, m; `sense`: 1 forwards, -1 backwards. Never more than
// advances(). `plate`: full edges along and across a foot's heading, m.
double furthest(const StrideBounds& bounds, const Strip& strip, const Vector2d& plate, const Foothold& from, double sense);

// False: no two strides lead from `u` to `v`, wherever the foothold between is; nor between ends that differ from these by no more
// than 1e-6 m and 1e-6 rad.
bool two_may_do(const StrideBounds& bounds, const Strip& strip, const Vector2d& plate, const Foothold& u, const Foothold& v);

}  // namespace foothold::hyrecro
