// The friction that a stance needs, and whether it stands with what there is.
#include <array>

#include "contact/critical_friction.hpp"
#include "hexpiderix/stance/stance.hpp"

namespace foothold::hexpiderix {
namespace {

struct Contacts {
  std::array<contact::Contact, kLegs> all{};
  std::size_t count = 0;
  explicit Contacts(const Footholds& footholds) {
    for (std::size_t leg = 0; leg < kLegs; ++leg)
      if (footholds.supports[leg]) all[count++] = {footholds.points[leg], footholds.normals[leg]};
  }
  std::span<const contact::Contact> span() const { return {all.data(), count}; }
};

}  // namespace

double friction_needed(const Footholds& footholds, const Vector3d& centre_of_mass) {
  return contact::critical_friction(Contacts(footholds).span(), centre_of_mass);
}

bool stands(contact::Equilibrium& equilibrium, const Footholds& footholds, const Vector3d& centre_of_mass, double friction) {
  return equilibrium.judge(Contacts(footholds).span(), centre_of_mass, friction).stable;
}

}  // namespace foothold::hexpiderix
