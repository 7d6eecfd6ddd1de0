#include "collision/segments.hpp"

#include <algorithm>

namespace foothold::collision {

namespace {

double squared_to_segment(const Vector3d& point, const Vector3d& from, const Vector3d& along, double along_squared) {
  const Vector3d w = point - from;
  const double t = along_squared > 0.0 ? std::clamp(w.dot(along) / along_squared, 0.0, 1.0) : 0.0;
  return (w - t * along).squaredNorm();
}

// sin^2 of the angle below which the dot products' determinant loses too many digits.
constexpr double kNearlyParallel = 1e-4;

// Nearest points a0 + s u and b0 + t v, s and t in [0, 1], where `s` is that of the free minimum: that, else the best one on a
// border.
double squared_from(double s, const Vector3d& u, const Vector3d& v, const Vector3d& w, double uu, double vv, double uv, double uw,
                    double vw) {
  s = std::clamp(s, 0.0, 1.0);
  double t = vv > 0.0 ? (uv * s + vw) / vv : 0.0;
  if (t < 0.0 || t > 1.0 || vv <= 0.0) {
    t = std::clamp(t, 0.0, 1.0);
    s = uu > 0.0 ? std::clamp((uv * t - uw) / uu, 0.0, 1.0) : 0.0;
  }
  return (w + s * u - t * v).squaredNorm();
}

}  // namespace

double squared_of_segments(const Vector3d& a0, const Vector3d& a1, const Vector3d& b0, const Vector3d& b1) {
  const Vector3d u = a1 - a0, v = b1 - b0, w = a0 - b0;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
  const double determinant = uu * vv - uv * uv;
  if (determinant > kNearlyParallel * uu * vv) return squared_from((uv * vw - vv * uw) / determinant, u, v, w, uu, vv, uv, uw, vw);
  // The same by cross products, which keep their digits; and as rounding may still hide which ends are nearest, each end.
  const Vector3d n = u.cross(v);
  const double nn = n.squaredNorm();
  const double best = squared_from(nn > 0.0 ? -n.dot(w.cross(v)) / nn : 0.0, u, v, w, uu, vv, uv, uw, vw);
  return std::min({best, squared_to_segment(a0, b0, v, vv), squared_to_segment(a1, b0, v, vv), squared_to_segment(b0, a0, u, uu),
                   squared_to_segment(b1, a0, u, uu)});
}

double squared_to_box(const Vector3d& p, const Vector3d& q, const Vector3d& half) {
  const Vector3d d = q - p;
  const auto slope = [&](double t) {
    const Vector3d x = p + t * d;
    return d.dot(x - x.cwiseMin(half).cwiseMax(-half));
  };
  double low = 0.0, high = 1.0, at_low = slope(0.0), at_high = slope(1.0);
  if (at_low >= 0.0) return squared_to_box(p, half);
  if (at_high <= 0.0) return squared_to_box(q, half);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double inverse = 1.0 / d[i];  // infinite: no bend along this axis, and no comparison holds
    for (const double bend : {(half[i] - p[i]) * inverse, (-half[i] - p[i]) * inverse}) {
      if (!(bend > low && bend < high)) continue;
      const double at = slope(bend);
      if (at < 0.0) {
        low = bend, at_low = at;
      } else {
        high = bend, at_high = at;
      }
    }
  }
  const double t = low + (high - low) * at_low / (at_low - at_high);
  return squared_to_box(p + t * d, half);
}

std::array<Vector3d, 8> corners_of(const Vector3d& centre, const Vector3d& x, const Vector3d& y, const Vector3d& z) {
  std::array<Vector3d, 8> out;
  for (std::size_t k = 0; k < 8; ++k)
    out[k] = centre + ((k & 1) != 0 ? x : Vector3d(-x)) + ((k & 2) != 0 ? y : Vector3d(-y)) + ((k & 4) != 0 ? z : Vector3d(-z));
  return out;
}

}  // namespace foothold::collision
