// What every judge of this library refuses, said once. Private.
#pragma once

#include "contact/contact.hpp"

namespace foothold::contact {

// Throws std::invalid_argument for a pyramid of 1, 2, less than 0 or more than 1024 edges.
void require_cone(FrictionCone cone);

// Throws std::invalid_argument if mu is negative, anything is not finite or a normal is not of unit length within 1e-6. Returns the
// greatest distance of a contact from the centre of mass, m; 1 if that is 0 or there is no contact.
double require_stance(std::span<const Contact> contacts, const Vector3d& com, double mu);

}  // namespace foothold::contact
