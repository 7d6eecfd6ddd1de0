#include "hyrecro/reach/planar_postures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace foothold::hyrecro {
namespace {

constexpr std::size_t kTable = 512;
// The table is linear between its entries and the choice is kept as float: so far (m) postures stay inside the limits.
constexpr double kInset = 2e-6;
constexpr std::size_t kSamples = 25;  // of s1, for each side

// From -1 to 1, dense at the ends, where tau turns fast.
const std::array<double, kSamples>& places() {
  static const std::array<double, kSamples> all = [] {
    std::array<double, kSamples> out{};
    for (std::size_t i = 0; i < kSamples; ++i)
      out[i] = -std::cos(std::numbers::pi * static_cast<double>(i) / static_cast<double>(kSamples - 1));
    return out;
  }();
  return all;
}

// Height at which a hip of this shift meets a limit: on the curve on which both mechanisms are `y(phi)` long at phi and -phi.
template <class Offset>
double height_on_curve(const Model& model, const Offset& y, double shift) {
  const auto length = [&](double phi) { return 2.0 * y(phi) - model.core; };
  double low = 0.0, high = model.mechanism.greatest_phi();
  for (int i = 0; i < 48; ++i) {
    const double middle = 0.5 * (low + high);
    (length(middle) * std::sin(middle) < shift ? low : high) = middle;
  }
  return length(low) * std::cos(low);
}

}  // namespace

Isometry3d to_isometry(const PlanarPose& pose) {
  Isometry3d out(Eigen::AngleAxisd(pose.heading, Vector3d::UnitZ()));
  out.translation() = Vector3d(pose.x, pose.y, 0.0);
  return out;
}

PlanarPose seen_from(const PlanarPose& a, const PlanarPose& b) {
  const double c = std::cos(a.heading), s = std::sin(a.heading), dx = b.x - a.x, dy = b.y - a.y;
  return {c * dx + s * dy, c * dy - s * dx, wrapped(b.heading - a.heading)};
}

PlanarPostures::PlanarPostures(const Model& model, double clearance) : model_(model), clearance_(clearance) {
  const auto& mechanism = model.mechanism;
  const double most = mechanism.greatest_phi();
  const auto low = [&](double phi) { return mechanism.offsets(phi).low; };
  const auto high = [&](double phi) { return mechanism.offsets(phi).high; };
  greatest_shift_ = (2.0 * low(most) - model.core) * std::sin(most);
  for (std::size_t i = 0; i <= kTable; ++i) {
    const double shift = greatest_shift_ * static_cast<double>(i) / kTable;
    table_.push_back({height_on_curve(model, low, shift) + kInset, height_on_curve(model, high, shift) - kInset});
  }
  // Not level, the upper mechanism may be straight at any phi1; hip_drop cancels, as both legs lean alike.
  double furthest = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const double phi = most * i / 100.0;
    furthest = std::max(furthest, (high(phi) + high(0.0) - model.core) * std::sin(phi));
  }
  greatest_reach_ = 2.0 * furthest + model.hip_distance;
}

PlanarPostures::Heights PlanarPostures::heights(double shift) const {
  const double place = std::fabs(shift) * static_cast<double>(kTable) / greatest_shift_;
  if (place >= static_cast<double>(kTable)) {
    const double middle = table_.back().low, beyond = std::fabs(shift) - greatest_shift_ + kInset;
    return {middle + beyond, middle - beyond};
  }
  const auto cell = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(cell);
  const Heights &a = table_[cell], &b = table_[cell + 1];
  return {a.low + part * (b.low - a.low), a.high + part * (b.high - a.high)};
}

PlanarPostures::Sample PlanarPostures::sample(const Placed& pose, const Choice& choice) const {
  const double t = model_.hip_distance, hip_x = pose.x + choice.shift1 * pose.c, hip_y = pose.y + choice.shift1 * pose.s;
  Sample out;
  out.shift1 = choice.shift1;
  out.sin_tau = std::clamp(hip_y / t, -1.0, 1.0);
  out.cos_tau = choice.side * std::sqrt((1.0 - out.sin_tau) * (1.0 + out.sin_tau));
  out.shift0 = hip_x - t * out.cos_tau;
  const Heights one = heights(out.shift0), two = heights(out.shift1);
  out.height = std::min(one.high, two.high);
  out.room = out.height - std::max(one.low, two.low);
  return out;
}

double PlanarPostures::volume(const Placed& pose, const Sample& at) const {
  const double r = model_.leg_radius, along = 0.5 * model_.hip_plate.x(), across = 0.5 * model_.hip_plate.y();
  const double ct = std::fabs(at.cos_tau), st = std::fabs(at.sin_tau), c = std::fabs(pose.c), s = std::fabs(pose.s);
  const double plate_x = 0.5 * model_.plate.x(), plate_y = 0.5 * model_.plate.y();
  struct Extent {
    double low, high;
    void cover(double middle, double half) {
      low = std::min(low, middle - half);
      high = std::max(high, middle + half);
    }
  };
  Extent x{-plate_x, plate_x}, y{-plate_y, plate_y};
  x.cover(pose.x, plate_x * c + plate_y * s);
  y.cover(pose.y, plate_x * s + plate_y * c);
  x.cover(at.shift0, r);
  y.cover(0.0, r);
  x.cover(pose.x + at.shift1 * pose.c, r);
  y.cover(pose.y + at.shift1 * pose.s, r);
  x.cover(at.shift0 + 0.5 * model_.hip_distance * at.cos_tau, along * ct + across * st);
  y.cover(0.5 * model_.hip_distance * at.sin_tau, along * st + across * ct);
  const double z = model_.ankle_height + at.height + model_.hip_drop + 0.5 * model_.hip_plate.z() - model_.skin;
  return (x.high - x.low) * (y.high - y.low) * z;
}

// Between the legs' capsules, less the clearance; negative if they are too near.
double PlanarPostures::legs_gap(const Placed& pose, const Sample& at) const {
  const auto leg = [&](double foot_x, double foot_y, double dx, double dy) {
    const Vector3d foot(foot_x, foot_y, model_.ankle_height), up(dx, dy, at.height);
    return collision::Capsule{foot + (model_.leg_begin / up.norm()) * up, foot + up, 0.0};
  };
  return collision::distance(leg(0.0, 0.0, at.shift0, 0.0), leg(pose.x, pose.y, at.shift1 * pose.c, at.shift1 * pose.s)) -
         2.0 * model_.leg_radius - clearance_;
}

bool PlanarPostures::plates_apart(const PlanarPose& pose) const {
  if (std::hypot(pose.x, pose.y) > std::hypot(model_.plate.x(), model_.plate.y()) + clearance_) return true;
  const auto plate = [&](const Isometry3d& sole) { return collision::Box{sole, 0.5 * model_.plate}; };
  return !collision::nearer(plate(Isometry3d::Identity()), plate(to_isometry(pose)), clearance_);
}

// Where between two neighbours of the best sample a posture is within limits and its legs are apart: golden section on the worse of
// both.
std::optional<PlanarPostures::Choice> PlanarPostures::refined(const Placed& pose, const Choice& from, const Choice& to) const {
  constexpr double ratio = 0.6180339887498949;
  const auto worse = [&](double shift1) {
    const Sample at = sample(pose, {shift1, from.side});
    return at.room <= 0.0 ? at.room : std::min(at.room, legs_gap(pose, at));
  };
  double low = from.shift1, high = to.shift1;
  double one = high - ratio * (high - low), two = low + ratio * (high - low), at_one = worse(one), at_two = worse(two);
  for (int i = 0; i < 24 && at_one < 0.0 && at_two < 0.0; ++i) {
    if (at_one > at_two) {
      high = two, two = one, at_two = at_one;
      at_one = worse(one = high - ratio * (high - low));
    } else {
      low = one, one = two, at_one = at_two;
      at_two = worse(two = low + ratio * (high - low));
    }
  }
  if (std::max(at_one, at_two) < 0.0) return std::nullopt;
  return Choice{at_one > at_two ? one : two, from.side};
}

std::optional<PlanarPostures::Choice> PlanarPostures::widest(const PlanarPose& planar) const {
  const Placed pose{planar.x, planar.y, std::cos(planar.heading), std::sin(planar.heading)};
  if (std::hypot(pose.x, pose.y) > 2.0 * greatest_shift_ + model_.hip_distance || !plates_apart(planar)) return std::nullopt;
  double low = -greatest_shift_, high = greatest_shift_;
  if (std::fabs(pose.s) > 1e-12) {
    // Less what rounding to float may do, lest the hip be further across than its distance.
    const double at = -pose.y / pose.s, half = model_.hip_distance / std::fabs(pose.s) - 1e-7;
    low = std::max(low, at - half);
    high = std::min(high, at + half);
  } else if (std::fabs(pose.y) > model_.hip_distance) {
    return std::nullopt;
  }
  if (low > high) return std::nullopt;

  const auto shift_at = [&](std::size_t i) { return 0.5 * (low + high) + 0.5 * (high - low) * places()[i]; };
  const auto rounded = [](double shift1, int side) { return Choice{static_cast<double>(static_cast<float>(shift1)), side}; };
  // Of the sample if it is within limits and its legs are apart, as `gap` then tells; else 0.
  const auto volume_of = [&](const Choice& choice, double& gap) {
    const Sample at = sample(pose, choice);
    gap = at.room <= 0.0 ? at.room : std::min(at.room, legs_gap(pose, at));
    return gap > 0.0 ? volume(pose, at) : 0.0;
  };
  double most = 0.0, step = 0.0, gap = 0.0;
  Choice best;
  std::array<std::array<double, kSamples>, 2> room{};
  for (const int side : {1, -1})
    for (std::size_t i = 0; i < kSamples; ++i) {
      const Choice choice = rounded(shift_at(i), side);
      const double here = volume_of(choice, room[side > 0 ? 0 : 1][i]);
      if (here <= most) continue;
      most = here;
      best = choice;
      step = 0.5 * (shift_at(std::min(i + 1, kSamples - 1)) - shift_at(i == 0 ? 0 : i - 1));
    }
  if (most > 0.0) {
    for (int halving = 0; halving < 4; ++halving) {
      step *= 0.5;
      for (const double to : {best.shift1 - step, best.shift1 + step}) {
        const Choice choice = rounded(std::clamp(to, low, high), best.side);
        const double here = volume_of(choice, gap);
        if (here <= most) continue;
        most = here;
        best = choice;
      }
    }
    return best;
  }
  for (const int side : {1, -1}) {
    const auto& r = room[side > 0 ? 0 : 1];
    for (std::size_t i = 0; i < kSamples; ++i) {
      const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, kSamples - 1);
      if (r[i] < r[before] || r[i] < r[after]) continue;
      const auto found = refined(pose, {shift_at(before), side}, {shift_at(after), side});
      if (!found) continue;
      const Choice choice = rounded(found->shift1, side);
      if (volume_of(choice, gap) > 0.0) return choice;
    }
  }
  return std::nullopt;
}

Coordinates PlanarPostures::coordinates(const PlanarPose& planar, const Choice& choice) const {
  const Sample at = sample({planar.x, planar.y, std::cos(planar.heading), std::sin(planar.heading)}, choice);
  const auto leg = [&](double shift) {
    const double phi = std::atan2(-shift, at.height), y = 0.5 * (std::hypot(shift, at.height) + model_.core);
    return Leg{phi, y, -phi, y};
  };
  const double tau = std::atan2(at.sin_tau, at.cos_tau);
  return {{leg(at.shift0), leg(at.shift1)}, {tau, wrapped(tau - planar.heading)}};
}

}  // namespace foothold::hyrecro
