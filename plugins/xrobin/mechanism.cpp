// Forward kinematics of Xrobin's mechanism in its eight binary states.
#include "mechanism.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "foothold/errors.hpp"

namespace foothold::xrobin {
namespace {

constexpr double kPi = std::numbers::pi;

// The root of a continuous `f` between `low` and `high`, where it changes its sign, to the last bit.
template <class F>
double bisect(F f, double low, double high) {
  const bool rises = f(low) < 0.0;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle <= std::min(low, high) || middle >= std::max(low, high)) return middle;
    ((f(middle) < 0.0) == rises ? low : high) = middle;
  }
}

// With one piston retracted and one extended, half the sum and a quarter of the difference of the squared equations give
//   (b + p cos phi)^2 + p^2 sin^2 phi + y^2 = (l^2 + r^2) / 2,   y p sin phi = (l^2 - r^2) / 4.
// This is the first less its right side, y eliminated, for phi > 0 and l extended; it falls from +infinity at phi = 0.
double mixed_residual(const Lengths& n, double phi) {
  const double y = (n.extended * n.extended - n.retracted * n.retracted) / (4.0 * n.p * std::sin(phi));
  return n.b * n.b + n.p * n.p + 2.0 * n.b * n.p * std::cos(phi) + y * y -
         0.5 * (n.extended * n.extended + n.retracted * n.retracted);
}

[[noreturn]] void no_configuration(const char* field, const Lengths& n, const std::string& why) {
  std::ostringstream out;
  out << why << " (slot.half_width " << n.b << " m, rail.half_width " << n.p << " m, piston.retracted " << n.retracted
      << " m, piston.extended " << n.extended << " m)";
  throw InvalidModel(field, out.str());
}

void demand_sound(const Lengths& n) {
  if (!(n.b > 0.0)) no_configuration("slot.half_width", n, "must be greater than 0");
  if (!(n.p > 0.0)) no_configuration("rail.half_width", n, "must be greater than 0");
  if (!(n.retracted > std::abs(n.p - n.b)))
    no_configuration("piston.retracted", n, "must be greater than the difference of the half widths");
  if (!(n.retracted < n.p + n.b)) no_configuration("piston.retracted", n, "must be less than the sum of the half widths");
  if (!(n.extended > n.p + n.b)) no_configuration("piston.extended", n, "must be greater than the sum of the half widths");
}

}  // namespace

Lengths with_exact_turns(double retracted, double extended) {
  const auto at = [&](double b) { return Lengths{b, std::sqrt(retracted * retracted - b * b), retracted, extended}; };
  const auto residual = [&](double b) { return mixed_residual(at(b), 0.25 * kPi); };
  const double most = retracted * std::sqrt(0.5);  // from there on b would exceed p
  if (!(retracted > 0.0 && extended > retracted && residual(0.0) < 0.0 && residual(most) > 0.0))
    throw std::domain_error("no slot and rail give turns of exactly 45 and 90 deg with pistons of these lengths");
  return at(bisect(residual, 0.0, most));
}

Mechanism::Mechanism(const Lengths& lengths) : lengths_(lengths) {
  const Lengths& n = lengths_;
  demand_sound(n);
  const double straight = std::sqrt(n.extended * n.extended - (n.b + n.p) * (n.b + n.p));
  const double quarter = std::acos((n.retracted * n.retracted - n.b * n.b - n.p * n.p) / (2.0 * n.b * n.p));
  const auto residual = [&](double phi) { return mixed_residual(n, phi); };
  if (!(residual(quarter) < 0.0))
    no_configuration("piston.extended", n, "with one piston extended there is no posture between both retracted and both extended");
  const double eighth = bisect(residual, 1e-3 * quarter, quarter);
  const double mixed_y = (n.extended * n.extended - n.retracted * n.retracted) / (4.0 * n.p * std::sin(eighth));
  configurations_ = {{
      {1, true, true, 'U', 0.0, straight, 0, 0},
      {2, false, true, 'V', -eighth, mixed_y, 0, -1},
      {3, false, false, 'V', -quarter, 0.0, -1, 0},
      {4, true, false, 'V', -eighth, -mixed_y, 0, -1},
      {5, true, true, 'V', 0.0, -straight, 0, 0},
      {6, false, true, 'U', eighth, -mixed_y, 0, 1},
      {7, false, false, 'U', quarter, 0.0, 1, 0},
      {8, true, false, 'U', eighth, mixed_y, 0, 1},
  }};
  for (int first = 1; first <= kConfigurations; ++first)
    for (int second = 1; second <= kConfigurations; ++second) {
      const PlanarPose end = b_in_a(first) * inverse(b_in_a(second));
      longest_cycle_ = std::max(longest_cycle_, std::hypot(end.x, end.y));
    }
}

Mechanism Mechanism::from_model(const RobotModel& model) {
  return Mechanism({model.number("slot.half_width", "m"), model.number("rail.half_width", "m"),
                    model.number("piston.retracted", "m"), model.number("piston.extended", "m")});
}

Pistons Mechanism::pistons(double phi, double y) const {
  const double across = lengths_.b + lengths_.p * std::cos(phi);
  const double lift = lengths_.p * std::sin(phi);
  return {std::hypot(across, y + lift), std::hypot(across, y - lift)};
}

Pistons Mechanism::pistons(int number) const {
  const Configuration& c = configuration(number);
  return {c.l_extended ? lengths_.extended : lengths_.retracted, c.r_extended ? lengths_.extended : lengths_.retracted};
}

}  // namespace foothold::xrobin
