#include "contact/critical_friction.hpp"

#include <algorithm>
#include <limits>

namespace foothold::contact {

namespace {

constexpr double kWidth = 1e-8;

}  // namespace

CriticalFriction critical_friction(Equilibrium& equilibrium, std::span<const Contact> contacts, const Vector3d& com) {
  CriticalFriction out;
  out.mu = std::numeric_limits<double>::infinity();
  // True if mu holds. Without a proof it counts as too little, and no end of the bracket is told of it.
  const auto holds = [&](double mu) {
    const Verdict& verdict = equilibrium.judge(contacts, com, mu);
    if (verdict.stable) {
      out.mu = mu;
      out.forces = verdict.forces;
    } else if (verdict.proved) {
      out.not_at = mu;
      out.separating = verdict.separating;
    }
    return verdict.stable;
  };
  if (holds(0.0)) return out;
  double low = 0.0, high = 1.0;
  while (!holds(high)) {
    if (high >= kGreatestFriction) return out;
    low = high;
    high *= 10.0;
  }
  while (high - low > kWidth * std::max(1.0, high)) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? high : low) = middle;
  }
  return out;
}

double critical_friction(std::span<const Contact> contacts, const Vector3d& com) {
  Equilibrium equilibrium(FrictionCone::circular());
  return critical_friction(equilibrium, contacts, com).mu;
}

}  // namespace foothold::contact
