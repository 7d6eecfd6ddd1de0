// Footholds in the world and on their faces.
#include "hyrecro/route/route.hpp"

#include <cmath>

namespace foothold::hyrecro {

Isometry3d pose_of(const truss::Truss& truss, const Foothold& foothold) {
  const Isometry3d& frame = truss.faces[static_cast<std::size_t>(foothold.face)].frame;
  const double c = std::cos(foothold.heading), s = std::sin(foothold.heading);
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() << c * frame.linear().col(0) + s * frame.linear().col(1), c * frame.linear().col(1) - s * frame.linear().col(0),
      frame.linear().col(2);
  pose.translation() = frame * Vector3d(foothold.at.x(), foothold.at.y(), 0.0);
  return pose;
}

double length_of(const truss::Truss& truss, const Route& route) {
  double length = 0.0;
  Vector3d before = pose_of(truss, route.start).translation();
  for (const Stride& stride : route.strides) {
    const Vector3d at = pose_of(truss, stride.to).translation();
    length += (at - before).norm();
    before = at;
  }
  return length;
}

std::array<Vector2d, 4> footprint(const Model& model, const Foothold& foothold) {
  const Vector2d forward = 0.5 * model.plate.x() * Vector2d(std::cos(foothold.heading), std::sin(foothold.heading));
  const Vector2d left = 0.5 * model.plate.y() * Vector2d(-std::sin(foothold.heading), std::cos(foothold.heading));
  return {foothold.at - forward - left, foothold.at + forward - left, foothold.at + forward + left, foothold.at - forward + left};
}

}  // namespace foothold::hyrecro
