#include "hyrecro/reach/reach_filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>

#include "hyrecro/reach/inverse.hpp"
#include "hyrecro/reach/leg_plane.hpp"

namespace foothold::hyrecro {
namespace {

using Interval = LegShifts::Interval;

constexpr std::array<double, 8> kBalls{0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2};  // heights of middles tried, in longest legs
constexpr double kRounding = 1e-6;                                               // m
constexpr double kBallMargin = 1e-3;  // m: more than the arcs of a cell of leans stand out from its corners

// The whole number at or below: std::floor() is a call.
int below(double x) {
  const int cut = static_cast<int>(x);
  return cut - (x < cut ? 1 : 0);
}

double distance_squared(const Vector2d& point, const Vector2d& along, const Interval& part) {
  const double at = std::clamp(point.dot(along), static_cast<double>(part.low), static_cast<double>(part.high));
  return (point - at * along).squaredNorm();
}

// Whether some s0 of `a` and s1 of `b` put place + s1 e1 - s0 e0 to the distance t, e0 = (1, 0).
bool meets(const Interval& a, const Interval& b, const Vector2d& place, const Vector2d& e1, double t) {
  const double farther = (t - kRounding) * (t - kRounding), nearer = (t + kRounding) * (t + kRounding);
  double most = 0.0;
  for (const double s0 : {a.low, a.high})
    for (const double s1 : {b.low, b.high}) most = std::max(most, (place + s1 * e1 - Vector2d(s0, 0.0)).squaredNorm());
  if (most < farther) return false;
  for (const double s0 : {a.low, a.high})
    if (distance_squared(Vector2d(s0, 0.0) - place, e1, b) <= nearer) return true;
  for (const double s1 : {b.low, b.high})
    if (distance_squared(place + s1 * e1, Vector2d::UnitX(), a) <= nearer) return true;
  // Two lines that cross within both intervals.
  if (std::fabs(e1.y()) < 1e-9) return false;
  const double s1 = -place.y() / e1.y(), s0 = place.x() + s1 * e1.x();
  return s0 >= a.low && s0 <= a.high && s1 >= b.low && s1 <= b.high;
}

}  // namespace

ReachFilter::ReachFilter(const Model& model) : shifts_(model), hip_distance_(model.hip_distance) {
  const double longest = 2.0 * model.mechanism.offsets(0.0).high - model.core;
  reach_ = 2.0 * (model.ankle_height + longest + model.hip_drop) + model.hip_distance;
  set_ball(longest);
  for (int level = 0; level < LegShifts::kLevels; ++level) {
    auto& middles = middles_.emplace_back();
    for (int lean = 0; lean < shifts_.leans(level); ++lean) {
      const double psi = (lean + 0.5) * shifts_.lean_step(level) - shifts_.most_lean();
      middles.push_back({psi, std::cos(psi), std::sin(psi)});
    }
  }
}

// The best middle by coarse cells, its radius by the finest.
void ReachFilter::set_ball(double longest) {
  const auto radius = [&](double middle, int level) {
    double most = 0.0;
    for (int lean = 0; lean < shifts_.leans(level); ++lean)
      for (int side = 0; side < 2; ++side) {
        const double psi = (lean + side) * shifts_.lean_step(level) - shifts_.most_lean(), c = std::cos(psi), s = std::sin(psi);
        for (int height = 0; height < shifts_.heights(level); ++height) {
          const Interval part = shifts_.at(level, lean, height);
          if (part.empty()) continue;
          for (const double along : {part.low, part.high})
            for (const double up : {height * shifts_.height_step(level), (height + 1) * shifts_.height_step(level)}) {
              const double x = along * c - up * s, y = along * s + up * c - middle;
              most = std::max(most, x * x + y * y);
            }
        }
      }
    return std::sqrt(most) + kBallMargin;
  };
  ball_radius_ = 1e9;
  for (const double part : kBalls)
    if (const double here = radius(part * longest, 2); here < ball_radius_) ball_radius_ = here, ball_height_ = part * longest;
  ball_radius_ = radius(ball_height_, 0);
}

// `place`: of the second sole, across the plate's normal; it stands `rise` higher along that normal than the first.
bool ReachFilter::regular(const Turn::Way& way, double rise, const Vector2d& place, int level, int height) const {
  const Interval a = shifts_.of_lean(level, way.first, height);
  if (a.empty()) return false;
  const double step = shifts_.height_step(level);
  Interval b;
  for (int j = below(height - (rise + kRounding) / step), last = below(height + 1 - (rise - kRounding) / step); j <= last; ++j)
    b.join(shifts_.of_lean(level, way.second, j));
  if (b.empty() || !meets(a, b, place, way.e1, hip_distance_)) return false;
  return level == 0 || regular(way, rise, place, level - 1, 2 * height) || regular(way, rise, place, level - 1, 2 * height + 1);
}

// All shifts are in line: the hip axes are `across` apart along it. Within a cell of psi1 psi0 turns by as much, and what is seen
// along the plate's normal with it.
bool ReachFilter::singular(const Singular& pose, int level, int lean, int height) const {
  const double wide = shifts_.lean_step(level), high = shifts_.height_step(level);
  const Turn& turn = pose.turn;
  const Direction& middle = middles_[static_cast<std::size_t>(level)][static_cast<std::size_t>(lean)];
  double psi0 = turn.lean0 + turn.turning * middle.lean;
  if (std::fabs(psi0) > std::numbers::pi) psi0 -= std::copysign(2.0 * std::numbers::pi, psi0);
  const double seen = (psi0 + shifts_.most_lean()) / wide;
  Interval a;
  for (int i = below(seen - 0.5 - kRounding), last = below(seen + 0.5 + kRounding); i <= last; ++i)
    a.join(shifts_.at(level, i, height));
  if (a.empty()) return false;
  const double c = turn.cosine * middle.cosine - turn.turning * turn.sine * middle.sine;
  const double s = turn.sine * middle.cosine + turn.turning * turn.cosine * middle.sine;
  const double slack = 0.5 * wide * pose.aside + kRounding;
  const double rise = -s * pose.p.x() + c * pose.p.y(), beside = c * pose.p.x() + s * pose.p.y();
  Interval b;
  for (int j = below(height - (rise + slack) / high), last = below(height + 1 - (rise - slack) / high); j <= last; ++j)
    b.join(shifts_.at(level, lean, j));
  if (b.empty()) return false;
  // e1 is e0 or its opposite.
  const double least = beside - slack + (turn.turning > 0.0 ? b.low : -b.high) - a.high;
  const double most = beside + slack + (turn.turning > 0.0 ? b.high : -b.low) - a.low;
  if (!((least <= pose.across && pose.across <= most) || (least <= -pose.across && -pose.across <= most))) return false;
  if (level == 0) return true;
  for (int part = 0; part < 4; ++part)
    if (singular(pose, level - 1, 2 * lean + part % 2, 2 * height + part / 2)) return true;
  return false;
}

// Leaning by psi, leg j's plane holds n(psi), the plate's normal, and e = (cos psi, sin psi), in which s is measured.
ReachFilter::Turn ReachFilter::turn(const Eigen::Matrix3d& orientation) const {
  Isometry3d wire = Isometry3d::Identity();
  wire.linear() = orientation;
  const Matrix3d r = PaperPose(wire).r;
  Turn out;
  out.singular = hyrecro::singular(wire);
  out.ball = ball(orientation);
  if (out.singular) {
    // psi0 = atan2(r00 sin psi1 - r01 cos psi1, r11 cos psi1 - r10 sin psi1)
    out.lean0 = std::atan2(-r(0, 1), r(1, 1));
    out.cosine = std::cos(out.lean0);
    out.sine = std::sin(out.lean0);
    out.turning = r(2, 2) > 0.0 ? 1.0 : -1.0;
    return out;
  }
  for (const double s1 : {1.0, -1.0}) {
    const double psi0 = std::atan2(s1 * r(1, 2), s1 * r(0, 2)), c = std::cos(psi0), s = std::sin(psi0);
    const double psi1 = std::atan2(-(c * r(1, 0) - s * r(0, 0)), c * r(1, 1) - s * r(0, 1));
    const int first = shifts_.lean(psi0), second = shifts_.lean(psi1);
    if (first < 0 || second < 0) continue;
    const Vector3d x(c, s, 0.0), e1 = r * Vector3d(std::cos(psi1), std::sin(psi1), 0.0);
    out.ways.push_back({first, second, Vector3d(-s, c, 0.0), x, {x.dot(e1), e1.z()}});
  }
  return out;
}

bool ReachFilter::may_reach(const Turn& turn, const Vector3d& place) const {
  if (place.squaredNorm() > reach_ * reach_ || (place + turn.ball).squaredNorm() > apart() * apart()) return false;
  const Vector3d p(place.x(), place.z(), -place.y());  // paper's axes
  constexpr int top = LegShifts::kLevels - 1;
  if (turn.singular) {
    const double square = hip_distance_ * hip_distance_ - p.z() * p.z();
    if (square < -kRounding) return false;
    const Singular pose{turn, p, std::hypot(p.x(), p.y()), std::sqrt(std::max(0.0, square))};
    for (int lean = 0; lean < shifts_.leans(top); ++lean)
      for (int height = 0; height < shifts_.heights(top); ++height)
        if (singular(pose, top, lean, height)) return true;
    return false;
  }
  return std::any_of(turn.ways.begin(), turn.ways.end(), [&](const Turn::Way& way) {
    const double rise = way.normal.dot(p);
    const Vector2d across(way.x.dot(p), p.z());
    for (int height = 0; height < shifts_.heights(top); ++height)
      if (regular(way, rise, across, top, height)) return true;
    return false;
  });
}

bool ReachFilter::may_reach(const Isometry3d& free_in_holding) const {
  const Vector3d place = free_in_holding.translation();
  if ((place + ball(free_in_holding.linear())).squaredNorm() > apart() * apart()) return false;
  return may_reach(turn(free_in_holding.linear()), place);
}

std::shared_ptr<const ReachFilter> shared_reach_filter(const Model& model) {
  using Numbers = std::array<double, 8>;
  constexpr std::size_t kMostKept = 4;
  static std::mutex mutex;
  static std::vector<std::pair<Numbers, std::shared_ptr<const ReachFilter>>> kept;
  const auto& mechanism = model.mechanism;
  const Numbers numbers{mechanism.base(), mechanism.body(),   mechanism.shortest(), mechanism.longest(),
                        model.core,       model.hip_distance, model.ankle_height,   model.hip_drop};
  const std::lock_guard lock(mutex);
  for (const auto& [of, filter] : kept)
    if (of == numbers) return filter;
  if (kept.size() == kMostKept) kept.erase(kept.begin());
  return kept.emplace_back(numbers, std::make_shared<const ReachFilter>(model)).second;
}

}  // namespace foothold::hyrecro
