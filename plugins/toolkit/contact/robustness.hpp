// How far a stance is from losing its equilibrium, as lengths and forces that one can measure.
#pragma once

#include "contact/equilibrium.hpp"

namespace foothold::contact {

struct Robustness {
  // Positive: equilibrium lasts in every horizontal direction up to this much at least. Negative: it takes this much at least
  // to bring the stance into equilibrium. Infinite: nothing along these directions ends it, or makes it. Positive ones are within
  // 1e-6, or, where the border is an arc round the centre of mass, within 1e-3 of themselves.
  double value = 0.0;
  Vector2d direction = Vector2d::Zero();  // towards the border's nearest point, along world X and Y; zero if infinite
};

// How far, m, the centre of mass may move horizontally: its distance from the border of the support region (Bretl and Lall 2008,
// "Testing static equilibrium for legged robots", IEEE Trans. Robotics 24(4)). On level ground that region is the support
// polygon; on slopes and among walls it is not. Found as they do, from points on the border and the planes that support it there,
// but only where the nearest point may be. Errors as Equilibrium::judge.
Robustness support_margin(Equilibrium& equilibrium, std::span<const Contact> contacts, const Vector3d& com, double mu);

// How hard, in weights, anything may push the centre of mass horizontally. Errors as Equilibrium::judge.
Robustness push_margin(Equilibrium& equilibrium, std::span<const Contact> contacts, const Vector3d& com, double mu);

}  // namespace foothold::contact
