// Capsule against capsule: the distance of two segments in closed form.
#include <algorithm>

#include "collision/distance.hpp"

namespace foothold::collision {
namespace {

// Nearest points a0 + s u and b0 + t v, s and t in [0, 1]: the free minimum, else the best one on a border.
double segment_distance_squared(const Vector3d& a0, const Vector3d& a1, const Vector3d& b0, const Vector3d& b1) {
  const Vector3d u = a1 - a0, v = b1 - b0, w = a0 - b0;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
  const double determinant = uu * vv - uv * uv;
  double s = determinant > 1e-12 * uu * vv ? std::clamp((uv * vw - vv * uw) / determinant, 0.0, 1.0) : 0.0;
  double t = vv > 0.0 ? (uv * s + vw) / vv : 0.0;
  if (t < 0.0 || t > 1.0) {
    t = std::clamp(t, 0.0, 1.0);
    s = uu > 0.0 ? std::clamp((uv * t - uw) / uu, 0.0, 1.0) : 0.0;
  }
  return (w + s * u - t * v).squaredNorm();
}

}  // namespace

double distance(const Capsule& a, const Capsule& b) {
  return std::max(0.0, std::sqrt(segment_distance_squared(a.a, a.b, b.a, b.b)) - a.radius - b.radius);
}

bool nearer(const Capsule& a, const Capsule& b, double clearance) {
  const double sum = a.radius + b.radius + clearance;
  return segment_distance_squared(a.a, a.b, b.a, b.b) < sum * sum;
}

}  // namespace foothold::collision
