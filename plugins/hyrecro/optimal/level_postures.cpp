#include "hyrecro/optimal/level_postures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace foothold::hyrecro {
namespace {

using Eigen::Vector2d;

constexpr int kCells = 64;  // of the table; narrow where the shift is nearly the greatest
// Where in the interval of heights that both shifts leave, in turn.
constexpr std::array<double, 4> kHeights{0.5, 0.9, 0.1, 0.7};
constexpr int kAngles = 8192;
constexpr double kLeastAbove = 2e-5;                                                         // m, above the lowest height
constexpr std::array<double, 9> kAbove{0.0, 0.003, 0.02, 0.06, 0.15, 0.3, 0.5, 0.75, 0.97};  // shares of all heights

}  // namespace

LevelPostures::LevelPostures(const Model& model, double greatest_shift) : model_(model), greatest_shift_(greatest_shift) {
  const double top = 2.0 * model.mechanism.offsets(0.0).high - model.core;
  constexpr int steps = 64;
  for (int i = 0; i <= kCells; ++i) {
    const double rest = 1.0 - static_cast<double>(i) / kCells, shift = greatest_shift * (1.0 - rest * rest);
    const auto possible = [&](double height) { return leg(shift, height).has_value(); };
    const auto limit = [&](double inside, double outside) {
      for (int round = 0; round < 20; ++round) {
        const double middle = 0.5 * (inside + outside);
        (possible(middle) ? inside : outside) = middle;
      }
      return inside;
    };
    Heights found;
    for (int j = 1; j <= steps; ++j) {
      const double height = top * j / steps;
      if (!possible(height)) continue;
      if (found.high < found.low) found.low = height;
      found.high = height;
    }
    if (found.high >= found.low) found = {limit(found.low, found.low - top / steps), limit(found.high, found.high + top / steps)};
    table_.push_back(found);
  }
}

// By angles, each of which allows an interval of heights; of each run of angles that allow a height the ends and the middle.
std::vector<LevelPostures::Level> LevelPostures::spread() const {
  std::vector<Level> out;
  const double most = model_.mechanism.greatest_phi();
  const auto heights_at = [&](int i) {
    const double phi = most * i / kAngles;
    const kinematics::Interval y = model_.mechanism.offsets(phi);
    if (y.empty()) return Heights{};
    return Heights{std::cos(phi) * (2.0 * y.low - model_.core), std::cos(phi) * (2.0 * y.high - model_.core)};
  };
  std::vector<Heights> by_angle;
  double lowest = 1e9, highest = 0.0;
  for (int i = 0; i <= kAngles; ++i) {
    by_angle.push_back(heights_at(i));
    if (by_angle.back().high < by_angle.back().low) continue;
    lowest = std::min(lowest, by_angle.back().low);
    highest = std::max(highest, by_angle.back().high);
  }
  for (const double above : kAbove) {
    const double height = lowest + kLeastAbove + above * (highest - lowest);
    Level level{height, {}};
    const auto shift = [&](int i) { return height * std::tan(most * i / kAngles); };
    int first = -1;
    for (int i = 0; i <= kAngles + 1; ++i) {
      const bool possible = i <= kAngles && by_angle[static_cast<std::size_t>(i)].low <= height &&
                            height <= by_angle[static_cast<std::size_t>(i)].high;
      if (possible && first < 0) first = i;
      if (possible || first < 0) continue;
      for (const int angle : {i - 1, (first + i - 1) / 2, first})
        for (const double sense : {1.0, -1.0}) level.shifts.push_back(sense * shift(angle));
      first = -1;
    }
    out.push_back(std::move(level));
  }
  return out;
}

std::optional<Coordinates> LevelPostures::posture(double shift0, double shift1, double height, double tau, double heading) const {
  const std::optional<Leg> leg0 = leg(shift0, height), leg1 = leg(shift1, height);
  if (!leg0 || !leg1) return std::nullopt;
  return Coordinates{{*leg0, *leg1}, {wrapped(tau), wrapped(tau - heading)}};
}

LevelPostures::Heights LevelPostures::heights(double shift) const {
  const double share = std::fabs(shift) / greatest_shift_;
  if (share > 1.0) return {};
  const std::size_t cell = static_cast<std::size_t>(kCells * (1.0 - std::sqrt(1.0 - share)));
  const Heights& a = table_[cell];
  const Heights& b = table_[std::min<std::size_t>(cell + 1, kCells)];
  if (b.high < b.low) return a;
  return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

// A positive phi takes the pin backwards.
std::optional<Leg> LevelPostures::leg(double shift, double height) const {
  const double phi = std::atan2(-shift, height);
  const kinematics::Interval y = model_.mechanism.offsets(phi);
  const double each = 0.5 * (std::hypot(shift, height) + model_.core);
  if (!y.holds(each)) return std::nullopt;
  return Leg{phi, each, -phi, each};
}

bool LevelPostures::any(const Vector2d& place, double heading, const std::function<bool(const Coordinates&)>& take) const {
  const Vector2d e1(std::cos(heading), std::sin(heading));
  const double t = model_.hip_distance;
  const auto sign = [](double x) { return x < 0.0 ? -1.0 : 1.0; };
  const double towards0 = place.x(), towards1 = place.dot(e1), norm = std::max(1e-12, place.norm());
  const std::array<Vector2d, 5> shares{Vector2d(sign(towards0), sign(towards1)), Vector2d(towards0 / norm, towards1 / norm),
                                       Vector2d(sign(towards0), 0.0), Vector2d(0.0, sign(towards1)),
                                       Vector2d(sign(towards0), -sign(towards1))};
  for (const Vector2d& share : shares) {
    const Vector2d q = Vector2d(share.x(), 0.0) + share.y() * e1;
    const double a = q.squaredNorm(), b = place.dot(q), c = place.squaredNorm() - t * t;
    const double root = b * b - a * c;
    if (a < 1e-12 || root < 0.0) continue;
    for (const double x : {(b - std::sqrt(root)) / a, (b + std::sqrt(root)) / a}) {
      const double s0 = share.x() * x, s1 = -share.y() * x;
      const Heights h0 = heights(s0), h1 = heights(s1);
      const double low = std::max(h0.low, h1.low), high = std::min(h0.high, h1.high);
      if (low > high) continue;
      const Vector2d line = place - Vector2d(s0, 0.0) + s1 * e1;
      const double tau = std::atan2(line.y(), line.x());
      for (const double at : kHeights) {
        const double height = low + at * (high - low);
        const std::optional<Leg> leg0 = leg(s0, height), leg1 = leg(s1, height);
        if (leg0 && leg1 && take({{*leg0, *leg1}, {tau, wrapped(tau - heading)}})) return true;
      }
    }
  }
  return false;
}

}  // namespace foothold::hyrecro
