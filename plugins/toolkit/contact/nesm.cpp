#include "contact/nesm.hpp"

#include <cmath>
#include <limits>

namespace foothold::contact {

using Eigen::Vector3d;

double nesm_of_edge(const Vector3d& a, const Vector3d& b, const Vector3d& centre_of_mass) {
  const Vector3d along = (b - a).normalized();
  const Vector3d from_a = centre_of_mass - a;
  const Vector3d across = from_a - from_a.dot(along) * along;  // R
  const Vector3d rise = Vector3d::UnitZ() - along.z() * along;
  const double cos_psi = rise.norm();                    // of the edge against the horizontal
  const Vector3d left = Vector3d::UnitZ().cross(along);  // horizontal, of length cos psi
  const double theta = std::atan2(across.dot(left), across.dot(rise));
  const double height = across.norm() * (1.0 - std::cos(theta)) * cos_psi;
  return theta >= 0.0 ? height : -height;
}

Nesm nesm(const SupportPolygon& polygon, const Vector3d& centre_of_mass) {
  Nesm least{polygon.count < 3 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < polygon.count && polygon.count >= 3; ++i) {
    const double value = nesm_of_edge(polygon.corners[i], polygon.corners[(i + 1) % polygon.count], centre_of_mass);
    if (value < least.value) least = {value, i};
  }
  return least;
}

}  // namespace foothold::contact
