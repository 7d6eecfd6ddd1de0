#include "hyrecro/check/rates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace foothold::hyrecro {

// With u = (l^2 + r^2) / 2, v = (l^2 - r^2) / (4 b) the mechanism obeys y sin phi = v and y^2 = u - p^2 - b^2 + 2 p b cos phi. Let
// ' be the derivative by the piece's parameter; l and r are linear in it, so M = u' = l l' + r r' and N = l l' - r r' = 2 b v' are
// linear too and greatest at an end. Then
//   phi' = (N / (2 b) - sin phi M / (2 y)) / D,  D = y cos phi - p b sin^2 phi / y,  y' = (M / 2 - p b sin phi phi') / y.
// d phi / d l = l (1 / b - sin phi / y) / (2 D) > 0 and d phi / d r = -r (1 / b + sin phi / y) / (2 D) < 0 as y > b and D > 0: phi
// is extreme where one length is longest and the other shortest. y is bounded by the extremes of u and cos phi, and D, which grows
// with y and falls with |phi|, by the least y and the greatest |phi|.
MechanismRates mechanism_rates(const kinematics::PlanarMechanism& mechanism, const kinematics::PlanarMechanism::Lengths& from,
                               const kinematics::PlanarMechanism::Lengths& to) {
  const double b = mechanism.base(), p = mechanism.body();
  const double dl = to.left - from.left, dr = to.right - from.right;
  const auto [l_low, l_high] = std::minmax(from.left, to.left);
  const auto [r_low, r_high] = std::minmax(from.right, to.right);
  MechanismRates out;
  out.greatest_phi = std::max(std::fabs(mechanism.forward({l_high, r_low}).phi), std::fabs(mechanism.forward({l_low, r_high}).phi));
  const double sine = std::sin(out.greatest_phi), cosine = std::cos(out.greatest_phi);
  const double pb = p * b, rest = p * p + b * b;
  out.longest = std::sqrt(0.5 * (l_high * l_high + r_high * r_high) - rest + 2.0 * pb);
  const double shortest = std::sqrt(0.5 * (l_low * l_low + r_low * r_low) - rest + 2.0 * pb * cosine);
  const double d = shortest * cosine - pb * sine * sine / shortest;
  if (!(d > 0.0) || !(shortest > b) || !(out.greatest_phi < 0.5 * std::numbers::pi)) {
    out.phi = out.y = out.phi_bend = out.y_bend = std::numeric_limits<double>::infinity();
    return out;
  }
  const double m = std::max(std::fabs(from.left * dl + from.right * dr), std::fabs(to.left * dl + to.right * dr));
  const double n = std::max(std::fabs(from.left * dl - from.right * dr), std::fabs(to.left * dl - to.right * dr));
  out.phi = (n / (2.0 * b) + sine * m / (2.0 * shortest)) / d;
  out.y = (0.5 * m + pb * sine * out.phi) / shortest;
  const double m_change = dl * dl + dr * dr, n_change = std::fabs(dl * dl - dr * dr);
  const double d_change =
      out.y + out.longest * sine * out.phi + pb * (2.0 * sine * out.phi + sine * sine * out.y / shortest) / shortest;
  out.phi_bend = (n_change / (2.0 * b) + (out.phi * m + sine * m_change + sine * m * out.y / shortest) / (2.0 * shortest) +
                  out.phi * d_change) /
                 d;
  out.y_bend = (0.5 * m_change + pb * (out.phi * out.phi + sine * out.phi_bend) + out.y * out.y) / shortest;
  return out;
}

// Along the chain, each joint's speed times the greatest distance from its axis that the points behind it can have:
//   upper pin of leg 0      lambda0 phi1' + lambda0'                       (about the ankle pin, and along the leg)
//   hip plate               + psi0' (pin to the plate's farthest corner) + hip0' (axis 0 to that corner, in the plate's plane)
//   hip axis 1              + psi0' |(a2, t)| + hip0' t                    (the same for the point on axis 1)
//   leg 1, plate 1          + psi0' rho + |hip0' - hip1'| sigma + phi2' ... about the upper pin + lambda1' + phi1' ... about the
//   ankle pin
// where rho is the distance from the point on axis 1, sigma from the axis itself: the two hip axes are parallel, so their speeds
// add with sign; psi0 turns the whole rest about an axis through the upper pin of leg 0. A capsule moves as far as the farther one
// of its ends.
Rates rates_between(const Model& model, std::span<const double> from, std::span<const double> to, Foot holds) {
  const std::array<std::size_t, 2> first = holds == Foot::kA ? std::array<std::size_t, 2>{0, 4} : std::array<std::size_t, 2>{4, 0};
  const std::array<std::size_t, 2> hip = holds == Foot::kA ? std::array<std::size_t, 2>{8, 9} : std::array<std::size_t, 2>{9, 8};
  struct LegRates {
    MechanismRates ankle, upper;
    double length = 0.0, stretch = 0.0;
  };
  std::array<LegRates, 2> leg;
  for (std::size_t j = 0; j < 2; ++j) {
    const std::size_t k = first[j];
    leg[j].ankle = mechanism_rates(model.mechanism, {from[k], from[k + 1]}, {to[k], to[k + 1]});
    leg[j].upper = mechanism_rates(model.mechanism, {from[k + 2], from[k + 3]}, {to[k + 2], to[k + 3]});
    leg[j].length = leg[j].ankle.longest + leg[j].upper.longest - model.core;
    leg[j].stretch = leg[j].ankle.y + leg[j].upper.y;
  }
  const double hip0 = std::fabs(to[hip[0]] - from[hip[0]]);
  const double hips = std::fabs((to[hip[0]] - from[hip[0]]) - (to[hip[1]] - from[hip[1]]));
  const double psi0 = leg[0].ankle.phi + leg[0].upper.phi, t = model.hip_distance, a2 = model.hip_drop;

  Rates out;
  out.leg0 = std::max(model.leg_begin, leg[0].length) * leg[0].ankle.phi + leg[0].stretch;
  const double corner = std::hypot(0.5 * (t + model.hip_plate.x()), 0.5 * model.hip_plate.y());
  out.hip = out.leg0 + psi0 * std::hypot(corner, a2 + 0.5 * model.hip_plate.z()) + hip0 * corner;

  const double axis1 = out.leg0 + psi0 * std::hypot(a2, t) + hip0 * t;
  const double below = std::max(leg[1].length - model.leg_begin, 0.0);  // from the upper pin to the capsule's other end
  const double aside = std::sin(leg[1].upper.greatest_phi);
  out.leg1 = axis1 + psi0 * (a2 + below) + hips * below * aside + leg[1].upper.phi * below + leg[1].stretch;
  const double plate = std::hypot(0.5 * model.plate.x(), 0.5 * model.plate.y(), model.ankle_height);  // from the ankle pin
  out.plate1 = axis1 + psi0 * (a2 + leg[1].length + plate) + hips * (leg[1].length * aside + plate) +
               leg[1].upper.phi * (leg[1].length + plate) + leg[1].stretch + leg[1].ankle.phi * plate;

  // With w_i the speed and a_i the acceleration of joint i, r_i its greatest distance from the sole, W_i the sum of the speeds
  // before it: a turn adds a_i r_i + w_i (w_i + 2 W_i) r_i to the sole's second derivative, a stretch a_i + 2 W_i w_i; the
  // rotation's is at most the sum of a_i and the square of the sum of w_i.
  double turning = 0.0, accelerating = 0.0;
  const auto turn = [&](double speed, double acceleration, double lever) {
    out.bend1 += (acceleration + speed * (speed + 2.0 * turning)) * lever;
    turning += speed, accelerating += acceleration;
  };
  const auto stretch = [&](double speed, double acceleration) { out.bend1 += acceleration + 2.0 * turning * speed; };
  const double a = model.ankle_height, from_upper = leg[1].length + a, from_axis1 = leg[1].length * aside + a;
  turn(leg[0].ankle.phi, leg[0].ankle.phi_bend, leg[0].length + a2 + t + a2 + from_upper);
  stretch(leg[0].stretch, leg[0].ankle.y_bend + leg[0].upper.y_bend);
  turn(leg[0].upper.phi, leg[0].upper.phi_bend, a2 + t + a2 + from_upper);
  turn(hip0, 0.0, t + from_axis1);
  turn(std::fabs(to[hip[1]] - from[hip[1]]), 0.0, from_axis1);
  turn(leg[1].upper.phi, leg[1].upper.phi_bend, from_upper);
  stretch(leg[1].stretch, leg[1].ankle.y_bend + leg[1].upper.y_bend);
  turn(leg[1].ankle.phi, leg[1].ankle.phi_bend, a);
  out.bend_turn1 = accelerating + turning * turning;
  return out;
}

}  // namespace foothold::hyrecro
