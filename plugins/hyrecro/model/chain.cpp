#include "hyrecro/model/chain.hpp"

#include <cmath>
#include <numbers>

namespace foothold::hyrecro {
namespace {

// One leg in its own sole's frame: everything lies in the plane y = 0.
struct LegPoints {
  Vector3d upper_pin, hip;  // the hip axis' point in the middle of the hip plate
  double sine, cosine;      // of psi
};

// Paper's Rz(phi) takes our X to (cos phi, 0, sin phi) and our Z to (-sin phi, 0, cos phi).
LegPoints leg_points(const Model& model, const Leg& leg) {
  const double length = leg_length(model, leg), psi = leg.psi();
  LegPoints out;
  out.sine = std::sin(psi), out.cosine = std::cos(psi);
  out.upper_pin = {-length * std::sin(leg.phi1), 0.0, model.ankle_height + length * std::cos(leg.phi1)};
  out.hip = out.upper_pin + model.hip_drop * Vector3d(-out.sine, 0.0, out.cosine);
  return out;
}

Isometry3d isometry(const Eigen::Matrix3d& rotation, const Vector3d& translation) {
  Isometry3d out;
  out.linear() = rotation;
  out.translation() = translation;
  out.makeAffine();
  return out;
}

}  // namespace

const char* name_of(Foot foot) { return foot == Foot::kA ? "A" : "B"; }

Coordinates swapped(const Coordinates& c) {
  return {{c.leg[1], c.leg[0]}, {wrapped(c.hip[1] + std::numbers::pi), wrapped(c.hip[0] + std::numbers::pi)}};
}

double leg_length(const Model& model, const Leg& leg) { return leg.y1 + leg.y2 - model.core; }

// The chain written out, as products of sparse matrices take most of a search's time. With M_j = Rz(psi_j) of the paper in our
// frames, axes X0 Y0 Z0 of the hip plate = M_0 turned by hip0 about its Z, and the same turned by hip0 - hip1 before leg 1.
Frames frames(const Model& model, const Coordinates& c) {
  const LegPoints leg0 = leg_points(model, c.leg[0]), leg1 = leg_points(model, c.leg[1]);
  const auto turned = [&](double angle) {
    const double sine = std::sin(angle), cosine = std::cos(angle);
    Eigen::Matrix3d out;
    out << cosine * leg0.cosine, -sine * leg0.cosine, -leg0.sine,  //
        sine, cosine, 0.0,                                         //
        cosine * leg0.sine, -sine * leg0.sine, leg0.cosine;
    return out;
  };
  const Eigen::Matrix3d hip = turned(c.hip[0]), before_leg1 = turned(c.hip[0] - c.hip[1]);
  const Vector3d axis1 = leg0.hip + model.hip_distance * hip.col(0);
  Eigen::Matrix3d sole1;
  sole1.col(0) = leg1.cosine * before_leg1.col(0) - leg1.sine * before_leg1.col(2);
  sole1.col(1) = before_leg1.col(1);
  sole1.col(2) = leg1.sine * before_leg1.col(0) + leg1.cosine * before_leg1.col(2);

  Frames out;
  out.hip = isometry(hip, leg0.hip + 0.5 * model.hip_distance * hip.col(0));
  out.sole[0] = Isometry3d::Identity();
  out.sole[1] = isometry(sole1, axis1 - sole1 * leg1.hip);
  out.ankle_pin = {Vector3d(0.0, 0.0, model.ankle_height), out.sole[1].translation() + model.ankle_height * sole1.col(2)};
  out.upper_pin = {leg0.upper_pin, axis1 - model.hip_drop * hip.col(2)};
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
