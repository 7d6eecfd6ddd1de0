// The judge's test of static equilibrium: by the nearest wrench, not by the simplex method of the search, and only with forces that
// the checker of certificates accepts.
#pragma once

#include <span>

#include "contact/projection.hpp"

namespace foothold::octopod {

// Some contact forces inside the cones hold the robot, and were shown. `com`: m, world. Any thread.
bool balanced(std::span<const contact::Contact> contacts, const contact::Vector3d& com, double friction,
              contact::FrictionCone cone);

// Least friction in [0, most] at which the stance is in equilibrium, within 1e-6; `most` if it is not even then.
double least_friction(std::span<const contact::Contact> contacts, const contact::Vector3d& com, double most,
                      contact::FrictionCone cone);

}  // namespace foothold::octopod
