#include "hexpiderix/check/margins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/balance.hpp"

namespace foothold::hexpiderix {

double tipping_height(const std::vector<Support>& supports, const Vector3d& centre_of_mass) {
  double least = -std::numeric_limits<double>::infinity();
  bool any = false;
  for (const Support& a : supports)
    for (const Support& b : supports) {
      const Vector3d along = b.point - a.point;
      // Twice the area seen from above: an edge of the hull has every other support on its left.
      const auto left = [&](const Vector3d& p) { return along.x() * (p.y() - a.point.y()) - along.y() * (p.x() - a.point.x()); };
      const bool hull = along.head<2>().norm() > 0.0 && std::all_of(supports.begin(), supports.end(), [&](const Support& c) {
                          return &c == &a || &c == &b || left(c.point) > 0.0;
                        });
      if (!hull || supports.size() < 3) continue;
      const Vector3d unit = along.normalized();
      const Vector3d on_edge = a.point + (centre_of_mass - a.point).dot(unit) * unit;
      const double top = on_edge.z() + (centre_of_mass - on_edge).norm() * std::sqrt(1.0 - unit.z() * unit.z());
      const double height = left(centre_of_mass) >= 0.0 ? top - centre_of_mass.z() : centre_of_mass.z() - top;
      least = any ? std::min(least, height) : height;
      any = true;
    }
  return least;
}

bool balanced(const std::vector<Support>& supports, const Vector3d& centre_of_mass, double friction) {
  std::vector<contact::Contact> contacts;
  for (const Support& support : supports) contacts.push_back({support.point, support.normal});
  return contact::balanced(contacts, centre_of_mass, friction, contact::FrictionCone::circular());
}

}  // namespace foothold::hexpiderix
