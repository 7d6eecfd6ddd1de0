// Forces that a checker accepts, and the least friction by halving.
#include "octopod/check/balance.hpp"

#include "contact/certificate.hpp"

namespace foothold::octopod {

bool balanced(std::span<const contact::Contact> contacts, const contact::Vector3d& com, double friction,
              contact::FrictionCone cone) {
  if (contacts.empty()) return false;
  const contact::Verdict verdict = contact::judge_by_projection(contacts, com, friction, cone);
  return verdict.stable && contact::proves(verdict, contacts, com, friction, cone);
}

double least_friction(std::span<const contact::Contact> contacts, const contact::Vector3d& com, double most,
                      contact::FrictionCone cone) {
  if (!balanced(contacts, com, most, cone)) return most;
  double low = 0.0, high = most;
  while (high - low > 1e-6) {
    const double middle = 0.5 * (low + high);
    (balanced(contacts, com, middle, cone) ? high : low) = middle;
  }
  return high;
}

}  // namespace foothold::octopod
