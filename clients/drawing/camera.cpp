// The axes of the two views and what fits into them.
#include "camera.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace foothold::drawing {

Camera camera_above() { return {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()}; }

Camera camera_oblique(double azimuth, double elevation) {
  const double a = azimuth * M_PI / 180.0, e = elevation * M_PI / 180.0;
  const Vector3d right(-std::sin(a), std::cos(a), 0.0);
  const Vector3d towards(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
  return {right, towards.cross(right), towards};
}

Reach reach(const Camera& camera, const Points& points) {
  if (points.empty()) return {};
  Vector3d low, high;
  for (std::size_t i = 0; i < points.size(); ++i) {
    // From the first point on, so that a plan far from the world's origin keeps its digits.
    const Vector3d from = points[i] - points[0];
    const Vector3d seen(camera.right.dot(from), camera.up.dot(from), camera.towards.dot(from));
    low = i == 0 ? seen : low.cwiseMin(seen).eval();
    high = i == 0 ? seen : high.cwiseMax(seen).eval();
  }
  const Vector3d middle = (low + high) / 2.0;
  return {high.x() - low.x(), high.y() - low.y(),
          points[0] + camera.right * middle.x() + camera.up * middle.y() + camera.towards * middle.z()};
}

}  // namespace foothold::drawing
