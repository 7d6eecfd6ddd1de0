#include "hyrecro/model/chain.hpp"

#include <cmath>
#include <numbers>

namespace foothold::hyrecro {
namespace {

using Eigen::AngleAxisd;
using Eigen::Translation3d;

// R_wire = kToWire R_paper kToWire^T: X stays, Y (paper) is Z (wire), Z (paper) is -Y (wire).
Isometry3d rotation(double angle, const Vector3d& axis) { return Isometry3d(AngleAxisd(angle, axis)); }
Isometry3d about_mechanism(double angle) { return rotation(angle, -Vector3d::UnitY()); }  // Rz of the paper
Isometry3d about_normal(double angle) { return rotation(angle, Vector3d::UnitZ()); }      // Ry of the paper
Isometry3d up(double distance) { return Isometry3d(Translation3d(0.0, 0.0, distance)); }  // Ty of the paper

struct LegFrames {
  Vector3d ankle_pin, upper_pin;
  Isometry3d hip;  // L_j, in the sole's frame
};

LegFrames leg_frames(const Model& model, const Leg& leg) {
  LegFrames out;
  Isometry3d at = up(model.ankle_height);
  out.ankle_pin = at.translation();
  at = at * about_mechanism(leg.phi1) * up(leg_length(model, leg));
  out.upper_pin = at.translation();
  out.hip = at * about_mechanism(leg.phi2) * up(model.hip_drop);
  return out;
}

double wrapped(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); }

}  // namespace

const char* name_of(Foot foot) { return foot == Foot::kA ? "A" : "B"; }

Coordinates swapped(const Coordinates& c) {
  return {{c.leg[1], c.leg[0]}, {wrapped(c.hip[1] + std::numbers::pi), wrapped(c.hip[0] + std::numbers::pi)}};
}

double leg_length(const Model& model, const Leg& leg) { return leg.y1 + leg.y2 - model.core; }

Frames frames(const Model& model, const Coordinates& c) {
  const LegFrames leg0 = leg_frames(model, c.leg[0]), leg1 = leg_frames(model, c.leg[1]);
  Frames out;
  const Isometry3d axis0 = leg0.hip * about_normal(c.hip[0]);
  out.hip = axis0 * Translation3d(0.5 * model.hip_distance, 0.0, 0.0);
  out.sole[0] = Isometry3d::Identity();
  out.sole[1] = axis0 * Translation3d(model.hip_distance, 0.0, 0.0) * about_normal(-c.hip[1]) * leg1.hip.inverse();
  out.ankle_pin = {leg0.ankle_pin, out.sole[1] * leg1.ankle_pin};
  out.upper_pin = {leg0.upper_pin, out.sole[1] * leg1.upper_pin};
  return out;
}

Isometry3d forward(const Model& model, const Coordinates& c) { return frames(model, c).sole[1]; }

bool within_limits(const Model& model, const Coordinates& c, double tolerance) {
  const double shortest = model.mechanism.shortest() - tolerance, longest = model.mechanism.longest() + tolerance;
  const auto kept = [&](double phi, double y) {
    const auto [l, r] = model.mechanism.lengths({phi, y});
    return y > 0.0 && std::fabs(phi) < 0.5 * std::numbers::pi && l >= shortest && l <= longest && r >= shortest && r <= longest;
  };
  for (const Leg& leg : c.leg)
    if (!kept(leg.phi1, leg.y1) || !kept(leg.phi2, leg.y2)) return false;
  return std::isfinite(c.hip[0]) && std::isfinite(c.hip[1]);
}

std::vector<double> to_joints(const Model& model, const Coordinates& c, Foot first) {
  const Coordinates from_a = first == Foot::kA ? c : swapped(c);
  std::vector<double> out;
  out.reserve(kJoints);
  for (const Leg& leg : from_a.leg)
    for (const auto [l, r] : {model.mechanism.lengths({leg.phi1, leg.y1}), model.mechanism.lengths({leg.phi2, leg.y2})}) {
      out.push_back(l);
      out.push_back(r);
    }
  out.push_back(from_a.hip[0]);
  out.push_back(from_a.hip[1]);
  return out;
}

Coordinates from_joints(const Model& model, std::span<const double> joints, Foot first) {
  Coordinates out;
  for (std::size_t j = 0; j < 2; ++j) {
    const auto ankle = model.mechanism.forward({joints[4 * j], joints[4 * j + 1]});
    const auto upper = model.mechanism.forward({joints[4 * j + 2], joints[4 * j + 3]});
    out.leg[j] = {ankle.phi, ankle.y, upper.phi, upper.y};
  }
  out.hip = {joints[8], joints[9]};
  return first == Foot::kA ? out : swapped(out);
}

}  // namespace foothold::hyrecro
