#include "hyrecro/motion/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foothold::hyrecro {
namespace {

struct Range {
  double low = 0.0, high = 0.0;
  double most() const { return std::max(std::fabs(low), std::fabs(high)); }
  double least() const { return low > 0.0 ? low : high < 0.0 ? -high : 0.0; }
};
Range between(double a, double b) { return {std::min(a, b), std::max(a, b)}; }
Range operator+(const Range& a, const Range& b) { return {a.low + b.low, a.high + b.high}; }
Range operator-(const Range& a, const Range& b) { return {a.low - b.high, a.high - b.low}; }
Range operator*(double s, const Range& a) { return s < 0.0 ? Range{s * a.high, s * a.low} : Range{s * a.low, s * a.high}; }
Range operator*(const Range& a, const Range& b) {
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))};
}
// Precondition: b.low > 0.
Range operator/(const Range& a, const Range& b) { return a * Range{1.0 / b.high, 1.0 / b.low}; }

// Changes over the whole way (the way's parameter runs from 0 to 1).
struct Rates {
  Range phi, y;
};

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// From y sin phi = v = (l^2 - r^2) / 4b and y^2 = (l^2 + r^2) / 2 - p^2 - b^2 + 2 p b cos phi: with the lengths' changes,
// G phi' = (l l' - r r') / 2b - sin phi (l l' + r r') / 2y, G = y cos phi - p b sin^2 phi / y; 2 y y' = l l' + r r' - 2 p b sin phi
// phi'. The enclosure [phi - reach, phi + reach] proves itself: while phi is inside, its rate cannot bring it to the border within
// half the way.
bool enclose(const Model& model, double l0, double r0, double l1, double r1, double phi, Rates& out) {
  const double b = model.mechanism.base(), pb = b * model.mechanism.body(),
               rest = b * b + model.mechanism.body() * model.mechanism.body();
  const double dl = l1 - l0, dr = r1 - r0;
  if (dl == 0.0 && dr == 0.0) {
    out = {};
    return true;
  }
  const Range turning = (0.5 / b) * between(l0 * dl - r0 * dr, l1 * dl - r1 * dr);
  const Range sliding = between(l0 * dl + r0 * dr, l1 * dl + r1 * dr);
  const double middle_squared = 0.125 * ((l0 + l1) * (l0 + l1) + (r0 + r1) * (r0 + r1)) - rest;
  const Range squared{middle_squared - 0.5 * sliding.most(), middle_squared + 0.5 * sliding.most()};
  double reach = 2.5 * (turning.most() + sliding.most());
  for (int i = 0; i < 6; ++i, reach *= 2.0) {
    const Range phis{phi - reach, phi + reach};
    if (phis.most() > 1.4) return false;
    const Range sine{std::sin(phis.low), std::sin(phis.high)};
    const double most = std::cos(phis.least()), least = std::cos(phis.most());
    const double under = squared.low + 2.0 * pb * least;
    if (under <= 0.0) return false;
    const Range y{std::sqrt(under), std::sqrt(squared.high + 2.0 * pb * most)};
    const double sine_most = sine.most(), sine_least = std::sin(phis.least());
    const Range g{y.low * least - pb * sine_most * sine_most / y.low, y.high * most - pb * sine_least * sine_least / y.high};
    if (g.low <= 0.0) return false;
    out.phi = (turning - 0.5 * (sine * (sliding / y))) / g;
    if (0.5 * out.phi.most() > reach) continue;
    out.y = 0.5 * ((sliding - (2.0 * pb) * (sine * out.phi)) / y);
    return true;
  }
  return false;
}

struct LegRates {
  double phi1 = 0.0, phi2 = 0.0, psi = 0.0, lambda = 0.0;  // greatest absolute changes
  double length = 0.0;                                     // m, greatest lambda on the way
};

bool enclose(const Model& model, const Actuators& a, const Actuators& b, int first, const Leg& middle, LegRates& out) {
  Rates ankle, upper;
  if (!enclose(model, a[first], a[first + 1], b[first], b[first + 1], middle.phi1, ankle) ||
      !enclose(model, a[first + 2], a[first + 3], b[first + 2], b[first + 3], middle.phi2, upper))
    return false;
  out = {ankle.phi.most(), upper.phi.most(), (ankle.phi + upper.phi).most(), (ankle.y + upper.y).most(), 0.0};
  out.length = std::fabs(leg_length(model, middle)) + 0.5 * out.lambda;
  return true;
}

}  // namespace

Sweep sweep(const Model& model, const Actuators& a, const Actuators& b, const Coordinates& middle) {
  LegRates leg0, leg1;
  if (!enclose(model, a, b, 0, middle.leg[0], leg0) || !enclose(model, a, b, 4, middle.leg[1], leg1))
    return {kInfinite, kInfinite, kInfinite, kInfinite, kInfinite, kInfinite};
  const double turn0 = std::fabs(b[8] - a[8]), turn1 = std::fabs(b[9] - a[9]);
  const double relative_turn = std::fabs((b[8] - a[8]) - (b[9] - a[9]));

  const double hip_radius = Vector3d(0.5 * (model.hip_distance + model.hip_plate.x()), 0.5 * model.hip_plate.y(),
                                     model.hip_drop + 0.5 * model.hip_plate.z())
                                .norm();
  const double plate_radius = Vector3d(0.5 * model.plate.x(), 0.5 * model.plate.y(), model.ankle_height).norm();

  // Velocities along the chain. The hip turns about leg 0's mechanism axis and about its own normal, which are perpendicular; leg
  // 1's axis is perpendicular to the normal as well, so turns about the normal add to each other and turns about both axes do.
  const double pin0 = std::hypot(leg0.length * leg0.phi1, leg0.lambda);
  const double hip_turn = std::hypot(leg0.psi, turn0);
  const double pin1 = pin0 + model.hip_distance * hip_turn;
  const double leg1_turn = std::hypot(leg0.psi + leg1.phi2, relative_turn);
  const double sole1_turn = std::hypot(leg0.psi + leg1.psi, relative_turn);
  const double ankle1 = std::hypot(leg1.length * leg1_turn, leg1.lambda);
  const double from_hip0 = std::hypot(leg0.length * std::hypot(leg0.phi2, turn0), leg0.lambda);
  const double from_hip1 = std::hypot(leg1.length * std::hypot(leg1.phi2, turn1), leg1.lambda);

  // From the middle of the way to its ends.
  Sweep out;
  out.leg0 = 0.5 * pin0;
  out.hip = 0.5 * (pin0 + hip_radius * hip_turn);
  out.leg1 = 0.5 * (pin1 + ankle1);
  out.plate1 = 0.5 * (pin1 + ankle1 + plate_radius * sole1_turn);
  out.plate1_about_hip = 0.5 * (from_hip1 + plate_radius * std::hypot(leg1.psi, turn1));
  out.legs = std::min(out.leg0 + out.leg1, 0.5 * (from_hip0 + from_hip1));
  return out;
}

}  // namespace foothold::hyrecro
