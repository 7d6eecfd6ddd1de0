#include "kinematics/planar_mechanism.hpp"

#include <cmath>

namespace foothold::kinematics {

PlanarMechanism::PlanarMechanism(double b, double p, double shortest, double longest)
    : b_(b), p_(p), shortest_(shortest), longest_(longest), greatest_phi_(0.0) {
  double some = 0.0, none = 1.5707963267948966;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (some + none);
    (offsets(middle).empty() ? none : some) = middle;
  }
  greatest_phi_ = some;
}

PlanarMechanism::Lengths PlanarMechanism::lengths(const Pose& pose) const {
  const double e = p_ - b_ * std::cos(pose.phi), d = b_ * std::sin(pose.phi);
  return {std::hypot(e, pose.y + d), std::hypot(e, pose.y - d)};
}

// y sin phi = v and y^2 = u - p^2 - b^2 + 2 p b cos phi leave y(phi) sin phi - v = 0, which grows with phi: Newton.
PlanarMechanism::Pose PlanarMechanism::forward(const Lengths& lengths) const {
  const double u = 0.5 * (lengths.left * lengths.left + lengths.right * lengths.right);
  const double v = (lengths.left - lengths.right) * (lengths.left + lengths.right) / (4.0 * b_);
  const double k = u - p_ * p_ - b_ * b_;
  const auto y_at = [&](double phi) { return std::sqrt(k + 2.0 * p_ * b_ * std::cos(phi)); };
  double phi = std::asin(std::fmin(1.0, std::fmax(-1.0, v / y_at(0.0))));
  for (int i = 0; i < 30; ++i) {
    const double y = y_at(phi), sine = std::sin(phi), cosine = std::cos(phi);
    const double change = (y * sine - v) / (y * cosine - p_ * b_ * sine * sine / y);
    phi -= change;
    if (std::fabs(change) < 1e-16) break;
  }
  return {phi, y_at(phi)};
}

Interval PlanarMechanism::offsets(double phi) const {
  const double e = p_ - b_ * std::cos(phi), d = b_ * std::fabs(std::sin(phi));
  if (std::fabs(e) > shortest_) return {};
  return {std::sqrt(shortest_ * shortest_ - e * e) + d, std::sqrt(longest_ * longest_ - e * e) - d};
}

}  // namespace foothold::kinematics
