#include "hyrecro/motion/lift.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "hyrecro/reach/inverse.hpp"

namespace foothold::hyrecro {
namespace {

constexpr int kDeepest = 10;          // halvings of a curve
constexpr double kOfTolerance = 0.4;  // what a way may use of it at its quarter points, so that all between stays below it

// Postures on a curve (parameter 0..1) so that the straight ways between them stay `near`.
struct Curve {
  const Model& model;
  std::function<std::optional<Coordinates>(double)> at;
  std::function<bool(const Coordinates&)> near;

  bool follow(double begin, const Coordinates& first, double end, const Coordinates& last, int depth,
              std::vector<Coordinates>& out) const {
    const Actuators a = to_actuators(model, first), b = with_nearest_turns(a, to_actuators(model, last));
    bool straight = true;
    for (const double part : {0.5, 0.25, 0.75}) straight = straight && near(from_actuators(model, a + part * (b - a)));
    if (straight) {
      out.push_back(last);
      return true;
    }
    const double middle = 0.5 * (begin + end);
    const std::optional<Coordinates> between = depth < kDeepest ? at(middle) : std::nullopt;
    return between && follow(begin, first, middle, *between, depth + 1, out) && follow(middle, *between, end, last, depth + 1, out);
  }

  std::optional<std::vector<Coordinates>> postures(const Coordinates& first, const Coordinates& last) const {
    std::vector<Coordinates> out{first};
    if (!follow(0.0, first, 1.0, last, 0, out)) return std::nullopt;
    return out;
  }
};

// The free sole's way along its normal.
struct Line {
  Isometry3d begin;
  double height = 0.0, tolerance = 0.0;
  Isometry3d at(double part) const { return begin * Eigen::Translation3d(0.0, 0.0, part * height); }
  bool holds(const Isometry3d& sole) const {
    const Isometry3d off = begin.inverse(Eigen::Isometry) * sole;
    const Vector3d& place = off.translation();
    return place.head<2>().squaredNorm() <= tolerance * tolerance && place.z() >= -tolerance && place.z() <= height + tolerance &&
           Eigen::AngleAxisd(off.linear()).angle() <= tolerance;
  }
};

double split_of(const Model& model, const Leg& leg) {
  const kinematics::Interval y1 = first_offsets(model, leg.phi1, leg.phi2, leg_length(model, leg));
  return y1.high > y1.low ? std::clamp((leg.y1 - y1.low) / (y1.high - y1.low), 0.0, 1.0) : 0.5;
}

std::optional<Coordinates> lifted(const Model& model, const Coordinates& stance, double height, double split) {
  const Leg& leg = stance.leg[1];
  const double length = leg_length(model, leg), forward = length * std::sin(leg.phi1), up = length * std::cos(leg.phi1) - height;
  const double phi1 = std::atan2(forward, up), lambda = std::hypot(forward, up), phi2 = leg.psi() - phi1;
  const kinematics::Interval y1 = first_offsets(model, phi1, phi2, lambda);
  if (y1.empty()) return std::nullopt;
  const double first = y1.low + split * (y1.high - y1.low);
  Coordinates out = stance;
  out.leg[1] = {phi1, first, phi2, lambda + model.core - first};
  return out;
}

}  // namespace

std::optional<Coordinates> lifted(const Model& model, const Coordinates& stance, double height) {
  return lifted(model, stance, height, split_of(model, stance.leg[1]));
}

bool legs_lift(const Model& model, const Coordinates& stance, double height) {
  return height == 0.0 || (lifted(model, stance, height) && lifted(model, swapped(stance), height));
}

double room_to_lift(const Model& model, const Coordinates& stance, double most) {
  const double split = split_of(model, stance.leg[1]);
  if (lifted(model, stance, most, split)) return most;
  double some = 0.0, none = most;
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (some + none);
    (lifted(model, stance, middle, split) ? some : none) = middle;
  }
  return some;
}

std::optional<std::vector<Coordinates>> lift(const Model& model, const Coordinates& stance, double height, double tolerance) {
  const double split = split_of(model, stance.leg[1]);
  const std::optional<Coordinates> top = lifted(model, stance, height, split);
  if (!top) return std::nullopt;
  const Line line{forward(model, stance), height, kOfTolerance * tolerance};
  const auto near = [&](const Coordinates& c) { return line.holds(forward(model, c)); };
  return Curve{model, [&](double part) { return lifted(model, stance, part * height, split); }, near}.postures(stance, *top);
}

std::optional<std::vector<Coordinates>> slide(const Model& model, const Coordinates& from, const Coordinates& to, double height,
                                              double tolerance) {
  const Line line{forward(model, from), height, kOfTolerance * tolerance};
  const Branch branch = branch_of(from);
  const Free first = free_of(model, from), last = free_of(model, to);
  const auto at = [&](double part) {
    const auto mixed = [&](double a, double b) { return a + part * (b - a); };
    const Free free{mixed(first.phi1, last.phi1), mixed(first.lambda, last.lambda), mixed(first.split0, last.split0),
                    mixed(first.split1, last.split1), mixed(first.psi1, last.psi1)};
    return inverse(model, line.at(part), branch, free);
  };
  const auto near = [&](const Coordinates& c) { return line.holds(forward(model, c)); };
  return Curve{model, at, near}.postures(from, to);
}

}  // namespace foothold::hyrecro
