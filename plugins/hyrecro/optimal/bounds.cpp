#include "hyrecro/optimal/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace foothold::hyrecro {
namespace {

constexpr double kRounding = 1e-9;  // m: what lies this near beyond a bound counts as within
constexpr double kCell = 5e-4;      // m, of shifts and heights
constexpr int kAngles = 4000;       // of a leg, from upright to the furthest lean
constexpr double kBetween = 1e-4;   // m: further than this from those angles' pins no pin is

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
  couple_shifts(model);
}

// Pins of upright legs (psi = 0) lie on radial segments, one for each phi. Between two neighbouring angles, at most 2.2e-4 rad
// apart, the ends of the segments move by less than 0.4 m/rad (their length is below 0.35 m and changes by less than 2 (b + p) a
// radian).
void StrideBounds::couple_shifts(const Model& model) {
  const double longest_leg = 2.0 * model.mechanism.offsets(0.0).high - model.core;
  const auto cell = [](double at) { return static_cast<std::size_t>(std::max(0.0, at) / kCell); };
  std::vector<double> greatest(cell(longest_leg) + 3, 0.0), smallest(greatest.size(), longest_leg);  // shift, by height
  std::vector<double> lowest(cell(shift_ + kBetween) + 2, longest_leg);                              // height, by shift
  for (int i = 0; i <= kAngles; ++i) {
    const double phi = model.mechanism.greatest_phi() * i / kAngles;
    const kinematics::Interval y = model.mechanism.offsets(phi);
    if (y.empty()) continue;
    const double shortest = 2.0 * y.low - model.core, longest = 2.0 * y.high - model.core;
    const double sine = std::sin(phi), cosine = std::cos(phi);
    for (std::size_t c = cell(shortest * cosine - kBetween); c <= cell(longest * cosine + kBetween); ++c) {
      const double top = std::min(longest * cosine, kCell * static_cast<double>(c + 1) + kBetween);
      greatest[c] = std::max(greatest[c], top * sine / cosine + kBetween);
      const double bottom = std::max(shortest * cosine, kCell * static_cast<double>(c) - kBetween);
      smallest[c] = std::min(smallest[c], bottom * sine / cosine - kBetween);
    }
    for (std::size_t s = cell(shortest * sine - kBetween); s <= cell(longest * sine + kBetween) && s < lowest.size(); ++s) {
      const double at = sine > 1e-6 ? (kCell * static_cast<double>(s) - kBetween) * cosine / sine : 0.0;
      lowest[s] = std::min(lowest[s], std::max(shortest * cosine, at) - kBetween);
    }
  }
  for (std::size_t c = 0; c < greatest.size(); ++c)
    if (greatest[c] > 0.0) upright_.push_back({std::max(0.0, smallest[c]), std::min(shift_, greatest[c])});
  std::sort(upright_.begin(), upright_.end(), [](const Upright& a, const Upright& b) { return a.most > b.most; });
  // From each height up.
  for (std::size_t c = greatest.size() - 1; c-- > 0;) greatest[c] = std::max(greatest[c], greatest[c + 1]);
  for (std::size_t s = lowest.size(); s-- > 0;) {
    const double low = kCell * static_cast<double>(s), other = std::min(shift_, greatest[cell(lowest[s])]);
    if (low > shift_) continue;
    if (!coupled_.empty() && other <= coupled_.back().other && coupled_.back().other - other < 1e-5)
      coupled_.back().low = low;
    else
      coupled_.push_back({low, std::min(shift_, low + kCell), other});
  }
}

double StrideBounds::advance(const Vector2d& heading, double low, double high) const {
  const double ahead = heading.x(), aside = heading.y();
  double best = 0.0;
  // With the hip's reach `radius`, and the own shift from `from` to `to`: a concave function of the shift, greatest at an end or
  // where the way to the strip's border runs along the heading.
  const auto look = [&](double radius, double from, double to) {
    if (std::max(from * ahead, to * ahead) + radius <= best) return;
    const auto value = [&](double shift) {
      const double beside = shift * aside, beyond = std::max({0.0, beside - high, low - beside});
      if (beyond < radius) best = std::max(best, shift * ahead + std::sqrt(radius * radius - beyond * beyond));
    };
    value(from);
    value(to);
    if (std::fabs(aside) < 1e-9) return;
    for (const double border : {low, high})
      for (const double beyond : {0.0, radius * ahead, -radius * ahead}) {
        const double shift = (border + beyond) / aside;
        if (shift > from && shift < to) value(shift);
      }
  };
  for (const Shifts& shifts : coupled_) {
    look(hip_distance_ + shifts.other, shifts.low, shifts.high);
    look(hip_distance_ + shifts.other, -shifts.high, -shifts.low);
  }
  // Singular postures: both shifts along one line, whatever they are.
  look(hip_distance_, -2.0 * shift_, 2.0 * shift_);
  return std::min(best, reach());
}

double StrideBounds::advance(const Vector2d& heading, double low, double high, const Vector2d& other, double turn,
                             double enough) const {
  double best = enough;
  // What a turn of the other heading changes lies within a disk, as what the hip's turn does.
  const double radius = hip_distance_ + shift_ * turn;
  const auto value = [&](const Vector2d& at) {
    const double beyond = std::max({0.0, at.y() - high, low - at.y()});
    if (beyond < radius) best = std::max(best, at.x() + std::sqrt(radius * radius - beyond * beyond));
  };
  // Concave along each line: greatest at an end or where the border's slope is the line's.
  const auto line = [&](const Vector2d& from, const Vector2d& way, double length) {
    value(from);
    value(from + length * way);
    if (std::fabs(way.y()) < 1e-9) return;
    for (const double border : {low, high})
      for (const double beyond : {0.0, radius * way.x(), -radius * way.x()}) {
        const double at = (border + beyond - from.y()) / way.y();
        if (at > 0.0 && at < length) value(from + at * way);
      }
  };
  const auto block = [&](double from0, double to0, double from1, double to1) {
    line(from0 * heading + from1 * other, heading, to0 - from0);
    line(from0 * heading + to1 * other, heading, to0 - from0);
    line(from0 * heading + from1 * other, other, to1 - from1);
    line(to0 * heading + from1 * other, other, to1 - from1);
  };
  const double both = std::fabs(heading.x()) + std::fabs(other.x());
  for (const Upright& at : upright_) {
    if (at.most * both + radius <= best) break;
    if (at.least < 1e-3) {
      block(-at.most, at.most, -at.most, at.most);
      continue;
    }
    for (const double one : {-1.0, 1.0})
      for (const double two : {-1.0, 1.0})
        block(std::min(one * at.least, one * at.most), std::max(one * at.least, one * at.most),
              std::min(two * at.least, two * at.most), std::max(two * at.least, two * at.most));
  }
  if (std::fabs(heading.x() * other.y() - heading.y() * other.x()) <= std::sin(std::min(1.5, turn)) + kRounding)
    line(-2.0 * shift_ * heading, heading, 4.0 * shift_);  // singular
  return std::min(best, reach());
}

int StrideBounds::least_along(double distance, double first, double last) const {
  if (distance <= std::min(first, last) + kRounding) return 1;
  return 2 + std::max(0, static_cast<int>(std::ceil((distance - first - last - kRounding) / reach())));
}

Strip strip_of(const Polygon& outline, double inset) {
  Strip best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d edge = outline[(i + 1) % outline.size()] - outline[i];
    if (edge.norm() < kRounding) continue;
    Strip strip{edge.normalized(), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Vector2d& corner : outline) {
      strip.low = std::min(strip.low, strip.across(corner));
      strip.high = std::max(strip.high, strip.across(corner));
    }
    if (strip.high - strip.low < least - kRounding) {
      least = strip.high - strip.low;
      best = strip;
    }
  }
  best.inset = inset;
  best.low += inset;
  best.high -= inset;
  return best;
}

Advances advances(const StrideBounds& bounds, const Strip& strip, const Foothold& foothold) {
  const Vector2d heading = direction(foothold.heading);
  const Vector2d seen(strip.along.dot(heading), strip.across(heading));
  const double at = strip.across(foothold.at), low = strip.low - at, high = strip.high - at;
  return {bounds.advance(seen, low, high), bounds.advance(-seen, -high, -low)};
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
