#include "hyrecro/reach/inverse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hyrecro/reach/leg_plane.hpp"

namespace foothold::hyrecro {
namespace {

// Rounding may take a value at its limit this far (m, or the sine of an angle) beyond it.
constexpr double kRounding = 1e-11;

// |sin| of the angle between the soles' Z axes.
double sine_between(const PaperPose& pose) { return std::hypot(pose.r(0, 2), pose.r(1, 2)); }

struct Turns {
  double psi0, psi1, hips;  // hips: hip0 - hip1
};

// psi0 first; psi1 and the hips then from Rz(-psi0) R = Ry(hips) Rz(-psi1), which is well conditioned however near to singular the
// pose is.
Turns turns(const PaperPose& pose, int s1, double psi1) {
  const Matrix3d& r = pose.r;
  double psi0 = 0.0;
  if (sine_between(pose) < kSingular) {
    const double c = std::cos(psi1), s = std::sin(psi1);
    psi0 = std::atan2(-(r(0, 1) * c - r(0, 0) * s), r(1, 1) * c - r(1, 0) * s);
  } else {
    psi0 = std::atan2(s1 * r(1, 2), s1 * r(0, 2));
    const double c = std::cos(psi0), s = std::sin(psi0);
    psi1 = std::atan2(-(c * r(1, 0) - s * r(0, 0)), c * r(1, 1) - s * r(0, 1));
  }
  return {psi0, psi1, std::atan2(std::cos(psi0) * r(0, 2) + std::sin(psi0) * r(1, 2), r(2, 2))};
}

std::optional<Leg> leg_with(const Model& model, double phi1, double lambda, double psi, double split) {
  const double phi2 = wrapped(psi - phi1);
  const kinematics::Interval y1 = first_offsets(model, phi1, phi2, lambda);
  if (y1.empty()) return std::nullopt;
  const double first = y1.low + split * (y1.high - y1.low);
  return Leg{phi1, first, phi2, lambda + model.core - first};
}

}  // namespace

bool singular(const Isometry3d& free_in_holding) { return sine_between(PaperPose(free_in_holding)) < kSingular; }

kinematics::Interval first_offsets(const Model& model, double phi1, double phi2, double lambda) {
  // Beyond a right angle the offsets' formula describes the mechanism's other assembly.
  if (std::fabs(phi1) > 0.5 * std::numbers::pi || std::fabs(phi2) > 0.5 * std::numbers::pi) return {};
  const kinematics::Interval one = model.mechanism.offsets(phi1), two = model.mechanism.offsets(phi2);
  if (one.high < one.low - kRounding || two.high < two.low - kRounding) return {};
  const double sum = lambda + model.core;
  kinematics::Interval out{std::max(one.low, sum - two.high), std::min(one.high, sum - two.low)};
  if (out.empty() && out.low - out.high < kRounding) out.low = out.high = 0.5 * (out.low + out.high);
  return out;
}

std::optional<Coordinates> inverse(const Model& model, const Isometry3d& free_in_holding, const Branch& branch, const Free& free) {
  const PaperPose pose(free_in_holding);
  const Turns turn = turns(pose, branch.s1, free.psi1);
  const std::optional<Leg> leg1 = leg_with(model, free.phi1, free.lambda, turn.psi1, free.split1);
  if (!leg1) return std::nullopt;

  const Vector2d hip1 = hip_of_leg(model, free.phi1, free.lambda, turn.psi1);
  const Vector3d u = pose.p + pose.r.leftCols<2>() * hip1;
  const double sine = -u.z() / model.hip_distance;
  if (std::fabs(sine) > 1.0 + kRounding) return std::nullopt;
  const double cosine = branch.s2 * std::sqrt(std::max(0.0, (1.0 - sine) * (1.0 + sine)));
  const double angle0 = std::atan2(sine, cosine);

  const Vector2d forward0(std::cos(turn.psi0), std::sin(turn.psi0));
  const Vector2d w = u.head<2>() - model.hip_distance * cosine * forward0 - model.hip_drop * normal_at(turn.psi0) -
                     Vector2d(0.0, model.ankle_height);
  const std::optional<Leg> leg0 = leg_with(model, std::atan2(-w.x(), w.y()), w.norm(), turn.psi0, free.split0);
  if (!leg0) return std::nullopt;
  return Coordinates{{*leg0, *leg1}, {angle0, wrapped(angle0 - turn.hips)}};
}

Branch branch_of(const Coordinates& c) { return {std::sin(c.hip[0] - c.hip[1]) < 0.0 ? -1 : 1, std::cos(c.hip[0]) < 0.0 ? -1 : 1}; }

Free free_of(const Model& model, const Coordinates& c) {
  const auto split = [&](const Leg& leg) {
    const kinematics::Interval y1 = first_offsets(model, leg.phi1, leg.phi2, leg_length(model, leg));
    return y1.high > y1.low ? (leg.y1 - y1.low) / (y1.high - y1.low) : 0.5;
  };
  return {c.leg[1].phi1, leg_length(model, c.leg[1]), split(c.leg[0]), split(c.leg[1]), c.leg[1].psi()};
}

}  // namespace foothold::hyrecro
