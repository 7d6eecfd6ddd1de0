// Equilibrium for who checks what Equilibrium found: by the nearest wrench, not by the simplex method of a search, and only with
// forces that the checker of certificates accepts.
#pragma once

#include <span>

#include "contact/projection.hpp"

namespace foothold::contact {

// Some contact forces inside the cones hold the robot, and were shown. `com`: m, world. Any thread.
bool balanced(std::span<const Contact> contacts, const Vector3d& com, double friction, FrictionCone cone);

// Least friction in [0, most] at which the stance is in equilibrium, within 1e-6; `most` if it is not even then.
double least_friction(std::span<const Contact> contacts, const Vector3d& com, double most, FrictionCone cone);

}  // namespace foothold::contact
