// Forces that a checker accepts, and the least friction by halving.
#include "contact/balance.hpp"

#include "contact/certificate.hpp"

namespace foothold::contact {

bool balanced(std::span<const Contact> contacts, const Vector3d& com, double friction, FrictionCone cone) {
  if (contacts.empty()) return false;
  const Verdict verdict = judge_by_projection(contacts, com, friction, cone);
  return verdict.stable && proves(verdict, contacts, com, friction, cone);
}

double least_friction(std::span<const Contact> contacts, const Vector3d& com, double most, FrictionCone cone) {
  if (!balanced(contacts, com, most, cone)) return most;
  double low = 0.0, high = most;
  while (high - low > 1e-6) {
    const double middle = 0.5 * (low + high);
    (balanced(contacts, com, middle, cone) ? high : low) = middle;
  }
  return high;
}

}  // namespace foothold::contact
