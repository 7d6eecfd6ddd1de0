// The judge's stability: NESM by its definition, as the work that tipping over an edge takes, and equilibrium by the nearest
// wrench.
#pragma once

#include <vector>

#include "foothold/types.hpp"

namespace foothold::hexpiderix {

// A supporting foot: point (m) and the ground's unit normal.
struct Support {
  Vector3d point, normal;
};

// Least over the edges of the supports' hull of the height that the centre of mass gains until it stands over the edge; minus what
// it has fallen if it is outside already. Minus infinity if all supports stand in a line. m.
double tipping_height(const std::vector<Support>& supports, const Vector3d& centre_of_mass);

// Whether contact forces within the circular cones hold the robot, shown by forces that the checker of certificates accepts.
bool balanced(const std::vector<Support>& supports, const Vector3d& centre_of_mass, double friction);

}  // namespace foothold::hexpiderix
