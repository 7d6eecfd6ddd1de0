#include "contact/robustness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace foothold::contact {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kGap = 1e-6;  // between what is held at least and what is not
constexpr double kFar = 1e6;   // stands for infinity among the points
constexpr int kShots = 100;
constexpr int kShotsWithoutEnd = 8;  // after which no border in any direction seen means none

// The plane section of the contact wrench cone at w, along two wrenches: the set of all (a, b) for which w + a x + b y is held.
// Convex, and 0 is in it.
class Section {
 public:
  Section(const Equilibrium& equilibrium, const Vector6d& x, const Vector6d& y) : equilibrium_(equilibrium), x_(x), y_(y) {}

  Robustness nearest_border() {
    for (int k = 0; k < 3; ++k) shoot(2.0 * std::numbers::pi * k / 3.0);
    for (int shot = 3; shot < kShots; ++shot) {
      if (!std::isfinite(outside_.value) && shot > kShotsWithoutEnd) return {kInfinity, Vector2d::Zero()};
      const auto [inside, angle] = nearest_edge();
      if (outside_.value - inside <= kGap * std::max(1.0, inside)) break;
      shoot(angle);
    }
    return {std::min(nearest_edge().first, outside_.value), outside_.direction};
  }

 private:
  struct Point {
    double angle;
    Vector2d at;
  };

  void shoot(double angle) {
    const Vector2d along(std::cos(angle), std::sin(angle));
    const Reach reach = equilibrium_.reach(along.x() * x_ + along.y() * y_);
    if (std::isfinite(reach.length)) {
      const Vector2d normal(reach.supporting.dot(x_), reach.supporting.dot(y_));  // normal.along = 1
      const double distance = reach.length / normal.norm();
      if (distance < outside_.value) outside_ = {distance, normal.normalized()};
    }
    const Point point{angle, std::min(reach.length, kFar) * along};
    const auto after = std::ranges::upper_bound(points_, angle, {}, &Point::angle);
    points_.insert(after, point);
  }

  // Of the polygon of points: distance of the nearest edge, and the angle at which it lies.
  [[nodiscard]] std::pair<double, double> nearest_edge() const {
    std::pair<double, double> best{kInfinity, 0.0};
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vector2d &a = points_[i].at, &b = points_[(i + 1) % points_.size()].at;
      const Vector2d edge = b - a;
      const double length = edge.norm();
      if (!(length > 0.0)) continue;
      const Vector2d normal = Vector2d(edge.y(), -edge.x()) / length;
      if (const double distance = normal.dot(a); distance < best.first) {
        const double angle = std::atan2(normal.y(), normal.x());
        best = {distance, angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle};
      }
    }
    return best;
  }

  const Equilibrium& equilibrium_;
  const Vector6d x_, y_;
  std::vector<Point> points_;
  Robustness outside_{kInfinity, Vector2d::Zero()};
};

Robustness robustness(Equilibrium& equilibrium, std::span<const Contact> contacts, const Vector3d& com, double mu,
                      const Vector6d& x, const Vector6d& y) {
  const Verdict& verdict = equilibrium.judge(contacts, com, mu);
  if (equilibrium.reaches()) return Section(equilibrium, x, y).nearest_border();
  if (verdict.stable || !verdict.proved) return {};  // on the border, as far as numbers tell
  const Vector6d& u = verdict.separating;
  const Vector2d normal(u.dot(x), u.dot(y));
  if (!(normal.norm() > 0.0)) return {-kInfinity, Vector2d::Zero()};
  return {-u[2] / normal.norm(), -normal.normalized()};
}

}  // namespace

Robustness support_margin(Equilibrium& equilibrium, std::span<const Contact> contacts, const Vector3d& com, double mu) {
  // The weight at com + (a, b, 0) has the torque (a, b, 0) x (0, 0, 1) about com.
  return robustness(equilibrium, contacts, com, mu, -Vector6d::Unit(4), Vector6d::Unit(3));
}

Robustness push_margin(Equilibrium& equilibrium, std::span<const Contact> contacts, const Vector3d& com, double mu) {
  return robustness(equilibrium, contacts, com, mu, -Vector6d::Unit(0), -Vector6d::Unit(1));
}

}  // namespace foothold::contact
