// Checks the proof of a verdict about a stance from the definition alone, without anything of the method that found it.
#pragma once

#include "contact/equilibrium.hpp"

namespace foothold::contact {

// How far from exact a proof may be. Forces: unbalanced by this much (weights; torques by this much times the greatest distance of
// a contact from the centre of mass), outside their cone by this much, or by this part of mu.
constexpr double kBalanceTolerance = 1e-9;
// A separating wrench: y.w must exceed this part of |y|, ...
constexpr double kSeparationTolerance = 2e-10;
// ... and y.(f, r x f) must not exceed this part of y.w for any f of unit normal component: then no forces whose normal components
// add up to less than 100,000 weights hold the robot, whatever was lost by rounding.
constexpr double kOverhangTolerance = 1e-5;

// True if the verdict says that it is proved and its certificate proves what it says. Any thread.
bool proves(const Verdict& verdict, std::span<const Contact> contacts, const Vector3d& com, double mu, FrictionCone cone);

}  // namespace foothold::contact
