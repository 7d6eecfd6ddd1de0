#include "hyrecro/optimal/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foothold::hyrecro {
namespace {

constexpr double kRounding = 1e-9;  // m: what lies this near beyond a bound counts as within

// Greatest shift of a leg that leans by `psi`, m.
double greatest_shift(const Model& model, double psi) {
  const double limit = model.mechanism.greatest_phi();
  const auto shift = [&](double phi) {
    const kinematics::Interval ankle = model.mechanism.offsets(phi), upper = model.mechanism.offsets(psi - phi);
    if (ankle.empty() || upper.empty()) return 0.0;
    return (ankle.high + upper.high - model.core) * std::sin(phi);
  };
  constexpr int steps = 400;
  double best = 0.0, step = limit / steps, at = limit;
  for (int i = 0; i <= steps; ++i)
    if (const double value = shift(i * step); value > best) best = value, at = i * step;
  for (int round = 0; round < 3; ++round) {
    const double low = std::max(0.0, at - step), high = std::min(limit, at + step);
    step = (high - low) / 20;
    for (int i = 0; i <= 20; ++i)
      if (const double value = shift(low + i * step); value > best) best = value, at = low + i * step;
  }
  return best;
}

}  // namespace

StrideBounds::StrideBounds(const Model& model) : hip_distance_(model.hip_distance) {
  const double limit = 2.0 * model.mechanism.greatest_phi();
  constexpr int leans = 100;
  for (int i = 0; i <= leans; ++i) {
    const double psi = limit * i / leans;
    shift_ = std::max(shift_, 0.5 * (greatest_shift(model, psi) + greatest_shift(model, -psi)));
  }
  const double longest_leg = 2.0 * model.mechanism.offsets(0.0).high - model.core;
  transition_reach_ = 2.0 * (model.ankle_height + longest_leg + model.hip_drop) + model.hip_distance;
}

Vector2d StrideBounds::rest(const Vector2d& difference, const Vector2d& u, const Vector2d& v) const {
  const double s = shift_, cross = u.x() * v.y() - u.y() * v.x();
  if (std::fabs(cross) > 1e-12) {
    const double a = (difference.x() * v.y() - difference.y() * v.x()) / cross;
    const double b = (u.x() * difference.y() - u.y() * difference.x()) / cross;
    if (std::fabs(a) <= s && std::fabs(b) <= s) return Vector2d::Zero();
  }
  // On an edge of the parallelogram: one shift at its limit, the other in between.
  Vector2d best = difference;
  const auto try_edge = [&](const Vector2d& fixed, const Vector2d& free) {
    const Vector2d from = difference - fixed;
    const Vector2d left = from - std::clamp(from.dot(free), -s, s) * free;
    if (left.squaredNorm() < best.squaredNorm()) best = left;
  };
  for (const double side : {-s, s}) {
    try_edge(side * u, v);
    try_edge(side * v, u);
  }
  return best;
}

int StrideBounds::least_apart(double distance) const {
  const double rest = distance - reach() - kRounding;
  return rest <= 0.0 ? 1 : 1 + static_cast<int>(std::ceil(rest / reach()));
}

int StrideBounds::least(const Vector2d& difference, const Vector2d& heading_u, const Vector2d& heading_v) const {
  const double beyond = rest(difference, heading_u, heading_v).norm() - hip_distance_ - kRounding;
  if (beyond <= 0.0) return 1;
  return 1 + static_cast<int>(std::ceil(beyond / (2.0 * shift_ + hip_distance_)));
}

int StrideBounds::least(const Foothold& u, const Foothold& v) const {
  if (same(u, v)) return 0;
  return least(v.at - u.at, direction(u.heading), direction(v.heading));
}

bool same(const Foothold& a, const Foothold& b) {
  return a.face == b.face && (a.at - b.at).cwiseAbs().maxCoeff() < 1e-9 &&
         std::fabs(std::remainder(a.heading - b.heading, 2.0 * std::numbers::pi)) < 1e-9;
}

}  // namespace foothold::hyrecro
