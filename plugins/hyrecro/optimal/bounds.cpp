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

// Distance of `point` from the parallelogram { a u + b v : |a|, |b| <= s }, u and v of unit length.
double distance_to_shifts(const Vector2d& point, const Vector2d& u, const Vector2d& v, double s) {
  const double cross = u.x() * v.y() - u.y() * v.x();
  if (std::fabs(cross) > 1e-12) {
    const double a = (point.x() * v.y() - point.y() * v.x()) / cross, b = (u.x() * point.y() - u.y() * point.x()) / cross;
    if (std::fabs(a) <= s && std::fabs(b) <= s) return 0.0;
  }
  // An edge a = +-s, b in between, and the other way round; by symmetry only those on the point's side.
  const auto to_edge = [&](const Vector2d& fixed, const Vector2d& free) {
    const Vector2d from = point - fixed;
    const double along = std::clamp(from.dot(free), -s, s);
    return (from - along * free).norm();
  };
  return std::min(std::min(to_edge(s * u, v), to_edge(-s * u, v)), std::min(to_edge(s * v, u), to_edge(-s * v, u)));
}

}  // namespace

StrideBounds::StrideBounds(const Model& model) : model_distance_(model.hip_distance) {
  const double limit = 2.0 * model.mechanism.greatest_phi();
  constexpr int leans = 100;
  for (int i = 0; i <= leans; ++i) {
    const double psi = limit * i / leans;
    shift_ = std::max(shift_, 0.5 * (greatest_shift(model, psi) + greatest_shift(model, -psi)));
  }
  const double longest_leg = 2.0 * model.mechanism.offsets(0.0).high - model.core;
  transition_reach_ = 2.0 * (model.ankle_height + longest_leg + model.hip_drop) + model.hip_distance;
}

int StrideBounds::least(const Vector2d& difference, const Vector2d& heading_u, const Vector2d& heading_v) const {
  const double rest = distance_to_shifts(difference, heading_u, heading_v, shift_) - model_distance_ - kRounding;
  if (rest <= 0.0) return 1;
  return 1 + static_cast<int>(std::ceil(rest / (2.0 * shift_ + model_distance_)));
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
