#include "hyrecro/optimal/reach_filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "hyrecro/reach/inverse.hpp"
#include "hyrecro/reach/leg_plane.hpp"

namespace foothold::hyrecro {
namespace {

constexpr double kLeanStep = 0.0873, kHeightStep = 0.02;  // rad, m
constexpr int kLeanParts = 4, kAngles = 96, kLengths = 16;
constexpr std::array<double, 8> kBalls{0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2};  // heights of middles tried, in longest legs
constexpr double kMargin = 0.008;  // m: more than neighbours of the samples that fill the table lie apart, halved

double distance(const Vector2d& point, const Vector2d& along, double low, double high) {
  const double at = std::clamp(point.dot(along), low, high);
  return (point - at * along).norm();
}

}  // namespace

ReachFilter::ReachFilter(const Model& model) : hip_distance_(model.hip_distance) {
  const double most = model.mechanism.greatest_phi(), longest = 2.0 * model.mechanism.offsets(0.0).high - model.core;
  reach_ = 2.0 * (model.ankle_height + longest + model.hip_drop) + model.hip_distance;
  heights_ = static_cast<int>((model.ankle_height + longest + model.hip_drop) / kHeightStep) + 2;
  const int leans = 2 * static_cast<int>(2.0 * most / kLeanStep + 1.5) + 1;
  table_.resize(static_cast<std::size_t>(leans * heights_));
  std::array<double, kBalls.size()> balls{};
  for (int lean = 0; lean < leans; ++lean)
    for (int part = 0; part <= kLeanParts; ++part) {
      const double psi = (lean - leans / 2 + (static_cast<double>(part) / kLeanParts - 0.5)) * kLeanStep;
      for (int angle = 0; angle <= kAngles; ++angle) {
        const double phi2 = most * (2.0 * angle / kAngles - 1.0);
        const double phi1 = std::clamp(psi - phi2, -most, most);
        if (std::fabs(psi - phi2 - phi1) > kLeanStep / kLeanParts) continue;
        const kinematics::Interval ankle = model.mechanism.offsets(phi1), upper = model.mechanism.offsets(phi2);
        if (ankle.empty() || upper.empty()) continue;
        for (int length = 0; length <= kLengths; ++length) {
          const double share = static_cast<double>(length) / kLengths;
          const double lambda = (1.0 - share) * (ankle.low + upper.low) + share * (ankle.high + upper.high) - model.core;
          const double s = model.ankle_height * std::sin(psi) + lambda * std::sin(phi2);
          const double c = model.ankle_height * std::cos(psi) + lambda * std::cos(phi2) + model.hip_drop;
          if (length == 0 || length == kLengths)
            for (std::size_t k = 0; k < balls.size(); ++k) {
              const double middle = kBalls[k] * longest;
              const double x = s * std::cos(psi) - c * std::sin(psi), y = s * std::sin(psi) + c * std::cos(psi);
              balls[k] = std::max(balls[k], std::hypot(x, y - middle));
            }
          for (const double at : {c - kMargin, c + kMargin}) {
            const int height = std::clamp(static_cast<int>(at / kHeightStep), 0, heights_ - 1);
            Shifts& shifts = table_[static_cast<std::size_t>(lean * heights_ + height)];
            shifts = shifts.low > shifts.high ? Shifts{s - kMargin, s + kMargin}
                                              : Shifts{std::min(shifts.low, s - kMargin), std::max(shifts.high, s + kMargin)};
          }
        }
      }
    }
  const auto least = std::min_element(balls.begin(), balls.end());
  ball_radius_ = *least + kMargin;
  ball_height_ = kBalls[static_cast<std::size_t>(least - balls.begin())] * longest;
}

const ReachFilter::Shifts* ReachFilter::of_lean(double psi) const {
  const int leans = static_cast<int>(table_.size()) / heights_;
  const int lean = leans / 2 + static_cast<int>(std::lround(psi / kLeanStep));
  if (lean < 0 || lean >= leans) return nullptr;
  return &table_[static_cast<std::size_t>(lean * heights_)];
}

// The second sole stands `rise` higher along the plate's normal than the first, and at `place` across it; each known to `slack`.
bool ReachFilter::level(const Turn::Way& way, double rise, const Vector2d& place, double slack) const {
  const Shifts *first = way.first, *second = way.second;
  const Vector2d e0 = Vector2d::UnitX(), e1 = way.e1;
  const int least_down = static_cast<int>(std::floor((rise - slack) / kHeightStep));
  const int most_down = static_cast<int>(std::floor((rise + slack) / kHeightStep)) + 1;
  for (int i = 0; i < heights_; ++i) {
    const Shifts& a = first[i];
    if (a.low > a.high) continue;
    Shifts b;
    for (int j = std::max(0, i - most_down); j <= std::min(heights_ - 1, i - least_down); ++j)
      if (second[j].low <= second[j].high)
        b = b.low > b.high ? second[j] : Shifts{std::min(b.low, second[j].low), std::max(b.high, second[j].high)};
    if (b.low > b.high) continue;
    double most = 0.0, least = 1e9;
    for (const double s0 : {a.low, a.high}) {
      for (const double s1 : {b.low, b.high}) most = std::max(most, (place + s1 * e1 - s0 * e0).norm());
      least = std::min(least, distance(s0 * e0 - place, e1, b.low, b.high));
    }
    if (most + slack < hip_distance_) continue;
    for (const double s1 : {b.low, b.high}) least = std::min(least, distance(place + s1 * e1, e0, a.low, a.high));
    if (least <= hip_distance_ + slack) return true;
    // Two lines that cross within both intervals.
    const double cross = e0.x() * e1.y() - e0.y() * e1.x();
    if (std::fabs(cross) < 1e-9) continue;
    const double s0 = (place.x() * e1.y() - place.y() * e1.x()) / cross, s1 = (place.x() * e0.y() - place.y() * e0.x()) / cross;
    if (s0 >= a.low && s0 <= a.high && s1 >= b.low && s1 <= b.high) return true;
  }
  return false;
}

// Leaning by psi, leg j's plane holds n(psi), the plate's normal, and e = (cos psi, sin psi), in which s is measured.
ReachFilter::Turn ReachFilter::turn(const Eigen::Matrix3d& orientation) const {
  Isometry3d wire = Isometry3d::Identity();
  wire.linear() = orientation;
  const Matrix3d r = PaperPose(wire).r;
  Turn out;
  out.singular = singular(wire);
  out.ball = ball(orientation);
  const auto add = [&](double psi0, double psi1, double cell0) {
    const Shifts *first = of_lean(cell0), *second = of_lean(psi1);
    if (first == nullptr || second == nullptr) return;
    const Vector3d normal(-std::sin(psi0), std::cos(psi0), 0.0), x(std::cos(psi0), std::sin(psi0), 0.0);
    const Vector3d e1 = r * Vector3d(std::cos(psi1), std::sin(psi1), 0.0);
    out.ways.push_back({first, second, normal, x, {x.dot(e1), e1.z()}});
  };
  if (!out.singular) {
    for (const double s1 : {1.0, -1.0}) {
      const double psi0 = std::atan2(s1 * r(1, 2), s1 * r(0, 2)), c = std::cos(psi0), s = std::sin(psi0);
      add(psi0, std::atan2(-(c * r(1, 0) - s * r(0, 0)), c * r(1, 1) - s * r(0, 1)), psi0);
    }
    return out;
  }
  const int leans = static_cast<int>(table_.size()) / heights_;
  for (int i = 0; i < leans; ++i) {
    const double psi1 = (i - leans / 2) * kLeanStep, c = std::cos(psi1), s = std::sin(psi1);
    const double psi0 = std::atan2(r(0, 0) * s - r(0, 1) * c, r(1, 1) * c - r(1, 0) * s);
    // Within a cell of psi1 psi0 turns by as much, and what is seen along the plate's normal with it.
    for (const double side : {-0.5, 0.5}) add(psi0, psi1, psi0 + side * kLeanStep);
  }
  return out;
}

bool ReachFilter::may_reach(const Turn& turn, const Vector3d& place) const {
  if (place.squaredNorm() > reach_ * reach_ || (place + turn.ball).squaredNorm() > apart() * apart()) return false;
  if (turn.singular && std::fabs(place.y()) > hip_distance_) return false;
  const Vector3d p(place.x(), place.z(), -place.y());  // paper's axes
  const double slack = turn.singular ? 0.5 * kLeanStep * std::hypot(p.x(), p.y()) : 0.0;
  return std::any_of(turn.ways.begin(), turn.ways.end(), [&](const Turn::Way& way) {
    return level(way, way.normal.dot(p), {way.x.dot(p), p.z()}, slack);
  });
}

bool ReachFilter::may_reach(const Isometry3d& free_in_holding) const {
  const Vector3d place = free_in_holding.translation();
  if ((place + ball(free_in_holding.linear())).squaredNorm() > apart() * apart()) return false;
  return may_reach(turn(free_in_holding.linear()), place);
}

}  // namespace foothold::hyrecro
