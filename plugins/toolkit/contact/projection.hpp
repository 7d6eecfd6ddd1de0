// The same verdict as Equilibrium's by another method that shares no code with it: the point of the contact wrench cone that is
// nearest to the wrench that holds the weight. If they coincide, the forces at that point are the proof; if not, their difference
// separates (Moreau 1962). Found by the active sets of Lawson and Hanson 1974 (chapter 23, NNLS), whose columns are made when they
// are needed: the cone's direction that reaches farthest.
#pragma once

#include "contact/equilibrium.hpp"

namespace foothold::contact {

// For who checks what Equilibrium found: slower by some ten times. Same meaning of arguments, same errors. Any thread.
Verdict judge_by_projection(std::span<const Contact> contacts, const Vector3d& com, double mu, FrictionCone cone);

}  // namespace foothold::contact
