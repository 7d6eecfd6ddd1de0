// The friction that a stance needs.
#pragma once

#include "contact/equilibrium.hpp"

namespace foothold::contact {

// What is above this is called infinite.
constexpr double kGreatestFriction = 1000.0;

struct CriticalFriction {
  // The least coefficient known to hold the robot, with its forces in weights: infinity and none if even kGreatestFriction does
  // not.
  double mu = 0.0;
  std::vector<Vector3d> forces;
  // The greatest one known not to, with the separating wrench that proves it (as Verdict::separating); below 0 if the stance
  // needs no friction. mu - not_at is below 1e-8 of 1 or of mu, whichever is more, except within the rounding of the last verdicts.
  double not_at = -1.0;
  Vector6d separating = Vector6d::Zero();
};

// For the cone of `equilibrium`, by halving: some thirty questions, each from the last one's basis. Errors as Equilibrium::judge.
// Cones grow with mu, so that there is one such number.
CriticalFriction critical_friction(Equilibrium& equilibrium, std::span<const Contact> contacts, const Vector3d& com);

// For the circular cone.
double critical_friction(std::span<const Contact> contacts, const Vector3d& com);

}  // namespace foothold::contact
