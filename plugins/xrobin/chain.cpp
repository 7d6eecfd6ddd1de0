// Pins, residuals, Newton.
#include "chain.hpp"

#include <algorithm>

namespace foothold::xrobin {
namespace {

constexpr double kPlaneTolerance = 1e-7;   // m and rad
constexpr double kSquareResidual = 1e-16;  // m^2

}  // namespace

using Eigen::Vector2d;

const Contact& limb(const Posture& posture, const char* name) {
  const auto found = std::find_if(posture.stance.begin(), posture.stance.end(), [&](const Contact& c) { return c.limb == name; });
  if (found == posture.stance.end()) refuse("body ", name, " is not among the contacts");
  return *found;
}

Isometry3d body(const Isometry3d& contact) {
  Isometry3d out = contact;
  out.linear().col(0) = -contact.linear().col(1);
  out.linear().col(1) = contact.linear().col(0);
  return out;
}

Relative relative(const Isometry3d& a, const Isometry3d& b) {
  const Isometry3d r = a.inverse(Eigen::Isometry) * b;
  if (std::abs(r.translation().z()) > kPlaneTolerance || std::abs(r(2, 2) - 1.0) > kPlaneTolerance)
    refuse("the bodies do not lie in one plane");
  return {r.translation().head<2>(), std::atan2(r(1, 0), r(0, 0))};
}

Pistons measured(const Lengths& n, const Relative& b) {
  const Vector2d axis(std::cos(b.turn), std::sin(b.turn));
  const Vector2d left_pin = b.position - n.p * axis;
  const Vector2d right_pin = b.position + n.p * axis;
  return {(right_pin - Vector2d(-n.b, 0.0)).norm(), (left_pin - Vector2d(n.b, 0.0)).norm()};
}

Relative follow(const Lengths& n, Relative guess, double l, double r) {
  for (int round = 0; round < 20; ++round) {
    const double y = guess.position.y();
    const double c = std::cos(guess.turn);
    const double s = std::sin(guess.turn);
    const Pistons now = measured(n, guess);
    const Vector2d f(now.l * now.l - l * l, now.r * now.r - r * r);
    if (f.cwiseAbs().maxCoeff() < kSquareResidual) return guess;
    Eigen::Matrix2d jacobian;
    jacobian << 2.0 * n.p * (y * c - n.b * s), 2.0 * (y + n.p * s), -2.0 * n.p * (y * c + n.b * s), 2.0 * (y - n.p * s);
    const Vector2d d = jacobian.fullPivLu().solve(f);
    guess.turn -= d[0];
    guess.position.y() -= d[1];
  }
  return guess;
}

}  // namespace foothold::xrobin
