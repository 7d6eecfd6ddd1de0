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

// y sin phi = v and y^2 = u - p^2 - b^2 + 2 p b cos phi leave f(x) = y x - v = 0 with x = sin phi: Newton, without a trigonometric
// function. f grows and is concave for x > 0 (convex below), and y is greatest at 0; so the iterates never pass the root.
PlanarMechanism::Pose PlanarMechanism::forward(const Lengths& lengths) const {
  const double u = 0.5 * (lengths.left * lengths.left + lengths.right * lengths.right);
  const double v = (lengths.left - lengths.right) * (lengths.left + lengths.right) / (4.0 * b_);
  const double k = u - p_ * p_ - b_ * b_, pb = p_ * b_;
  // Squared at each step: what comes after a change of this size is below rounding.
  constexpr double kSettled = 1e-9;
  double sine = v / std::sqrt(k + 2.0 * pb), y = 0.0;
  for (int i = 0; i < 30; ++i) {
    const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
    y = std::sqrt(k + 2.0 * pb * cosine);
    const double change = (y * sine - v) / (y - pb * sine * sine / (cosine * y));
    sine -= change;
    if (std::fabs(change) < kSettled) break;
  }
  y = std::sqrt(k + 2.0 * pb * std::sqrt((1.0 - sine) * (1.0 + sine)));
  return {std::asin(sine), y};
}

Interval PlanarMechanism::offsets(double phi) const {
  const double e = p_ - b_ * std::cos(phi), d = b_ * std::fabs(std::sin(phi));
  if (std::fabs(e) > shortest_) return {};
  return {std::sqrt(shortest_ * shortest_ - e * e) + d, std::sqrt(longest_ * longest_ - e * e) - d};
}

}  // namespace foothold::kinematics
