// The normalised energy stability margin (NESM): how high a robot's centre of mass must rise before the robot tips over an edge of
// its support polygon. Hirose, Tsukagoshi, Yoneda, ICRA 2001; Garcia and Gonzalez de Santos, Robotica 2005.
//
// Metres, world frame, gravity along -Z. Values; any thread. It knows no friction: see equilibrium.hpp.
#pragma once

#include "contact/support_polygon.hpp"

namespace foothold::contact {

// Of one edge from a to b, with the support on its left seen from above: h = |R| (1 - cos theta) cos psi. R: from the edge to the
// centre of mass, across the edge; theta: turn of R into the vertical plane through the edge (by atan2: an arc sine folds it past
// 90 degrees); psi: the edge's inclination. Negative if the centre of mass lies outside the edge. Precondition: a and b do not
// coincide seen from above.
double nesm_of_edge(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& centre_of_mass);

struct Nesm {
  double value = 0.0;    // m; least over all edges; below 0: it tips
  std::size_t edge = 0;  // over which: from this corner to the next
};

// Without an area to stand on: minus infinity.
Nesm nesm(const SupportPolygon& polygon, const Eigen::Vector3d& centre_of_mass);

}  // namespace foothold::contact
