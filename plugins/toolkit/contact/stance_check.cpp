#include "contact/stance_check.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace foothold::contact {

namespace {

constexpr int kMostEdges = 1024;
constexpr double kUnitLength = 1e-6;

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument(what); }

}  // namespace

void require_cone(FrictionCone cone) {
  if (cone.edges != 0 && (cone.edges < 3 || cone.edges > kMostEdges))
    refuse("a friction pyramid has 3 to " + std::to_string(kMostEdges) + " edges (0: the circular cone), not " +
           std::to_string(cone.edges));
}

double require_stance(std::span<const Contact> contacts, const Vector3d& com, double mu) {
  if (!(mu >= 0.0) || !std::isfinite(mu)) refuse("mu must be finite and at least 0, not " + std::to_string(mu));
  if (!com.allFinite()) refuse("the centre of mass is not finite");
  double most = 0.0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const double squared = (contacts[i].point - com).squaredNorm();
    if (!std::isfinite(squared)) refuse("the point of contact " + std::to_string(i) + " is not finite");
    if (!(std::abs(contacts[i].normal.squaredNorm() - 1.0) <= 2.0 * kUnitLength))
      refuse("the normal of contact " + std::to_string(i) + " must be of unit length, not " +
             std::to_string(contacts[i].normal.norm()));
    most = std::max(most, squared);
  }
  return most > 0.0 ? std::sqrt(most) : 1.0;
}

}  // namespace foothold::contact
