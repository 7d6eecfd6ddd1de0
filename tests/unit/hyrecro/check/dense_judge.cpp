#include "dense_judge.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

namespace foothold::hyrecro {
namespace {

using Eigen::AngleAxisd;
using Eigen::Translation3d;

struct Pose {
  double phi = 0.0, y = 0.0;
};

// y = sqrt(u - p^2 - b^2 + 2 p b cos phi); y sin phi - v grows with phi.
Pose solved(const Model& model, double l, double r) {
  const double b = model.mechanism.base(), p = model.mechanism.body();
  const double u = 0.5 * (l * l + r * r), v = (l * l - r * r) / (4.0 * b);
  const auto y_at = [&](double phi) { return std::sqrt(u - p * p - b * b + 2.0 * p * b * std::cos(phi)); };
  double low = -1.3, high = 1.3;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (y_at(middle) * std::sin(middle) < v ? low : high) = middle;
  }
  return {low, y_at(low)};
}

// The paper's frame of a foot: X forward, Y out of the surface.
Isometry3d to_wire() {
  Isometry3d out = Isometry3d::Identity();
  out.linear().col(0) = Vector3d::UnitX();
  out.linear().col(1) = Vector3d::UnitZ();
  out.linear().col(2) = -Vector3d::UnitY();
  return out;
}

struct PaperLeg {
  Isometry3d ankle, pin, hip;  // from the sole, paper's frames
};

PaperLeg leg_of(const Model& model, const Pose& ankle, const Pose& upper) {
  PaperLeg out;
  const double lambda = ankle.y + upper.y - model.core;
  out.ankle = Isometry3d(Translation3d(0.0, model.ankle_height, 0.0)) * AngleAxisd(ankle.phi, Vector3d::UnitZ());
  out.pin = out.ankle * Translation3d(0.0, lambda, 0.0);
  out.hip = out.pin * AngleAxisd(upper.phi, Vector3d::UnitZ()) * Translation3d(0.0, model.hip_drop, 0.0);
  return out;
}

struct Bounds {
  double clearance, plates, pose, line, lift, overhang, speed, limits;
};

Bounds bounds_of(const CheckOptions& options, bool sharp) {
  if (sharp)
    return {options.clearance + 2e-4, 0.0, 0.9e-6, 0.9 * options.line_tolerance, options.lift + 1e-4, 0.0, 1.0 + 1e-10, 0.0};
  return {options.clearance - 1.05e-4, 1.05e-4, 1.1e-6, 1.51 * options.line_tolerance, options.lift - 2e-4, 2e-6, 1.0 + 1e-6, 2e-9};
}

double apart_by(const Isometry3d& a, const Isometry3d& b) {
  return std::max((a.translation() - b.translation()).norm(), (a.linear() - b.linear()).norm() / std::numbers::sqrt2);
}

template <class Body>
double nearest_solid(const truss::Truss& truss, const Body& body) {
  double least = 10.0;
  for (const truss::Solid& solid : truss.solids)
    least = std::min(least, collision::distance(body, collision::Box{solid.pose, solid.half}));
  return least;
}

std::string collision_in(const truss::Truss& truss, const Bodies& bodies, const Bounds& allowed) {
  for (const auto& leg : bodies.leg)
    if (const double is = nearest_solid(truss, leg); is < allowed.clearance) return "a leg comes within " + std::to_string(is);
  if (const double is = nearest_solid(truss, bodies.hip); is < allowed.clearance)
    return "the hip comes within " + std::to_string(is);
  for (collision::Box plate : bodies.plate) {
    plate.half = (plate.half.array() - allowed.plates).matrix();
    if (nearest_solid(truss, plate) <= 0.0) return "a plate is in a solid";
  }
  if (const double is = self_distance(bodies); is < allowed.clearance)
    return "the robot comes within " + std::to_string(is) + " of itself";
  return "";
}

Bodies placed_at(Bodies bodies, const Isometry3d& at) {
  for (auto& leg : bodies.leg) leg.a = at * leg.a, leg.b = at * leg.b;
  for (auto& plate : bodies.plate) plate.pose = at * plate.pose;
  bodies.hip.pose = at * bodies.hip.pose;
  return bodies;
}

std::string stand_in(const Model& model, const truss::Truss& truss, const Walk& walk, Foot holds, const Bounds& allowed) {
  const Isometry3d held = walk.before.stance[0].frame;
  const Chain is = chain_by_the_paper(model, walk.step.after.joints, holds);
  const Contact& placed = walk.step.placed[0];
  if (apart_by(held * is.sole[1], placed.frame) > allowed.pose) return "the contact is elsewhere";
  if (apart_by(held * is.base, walk.step.after.base) > allowed.pose) return "the base is elsewhere";
  const truss::Face& face = truss.faces[0];
  constexpr int kAlong = 200;
  for (int side = 0; side < 4; ++side)
    for (int k = 0; k < kAlong; ++k) {
      const double reach = 0.5 * model.plate.x() - allowed.overhang;
      const Vector3d on_edge =
          AngleAxisd(0.5 * std::numbers::pi * side, Vector3d::UnitZ()) * Vector3d(reach, reach * (2.0 * k / kAlong - 1.0), 0.0);
      const Vector3d point = face.frame.inverse() * (placed.frame * on_edge);
      if (std::fabs(point.z()) > 1.2e-6) return "the plate is off the plane";
      if (!geometry::contains(face.outline, point.head<2>())) return "the plate overhangs";
      for (const auto& hole : face.holes)
        if (geometry::contains(hole, point.head<2>())) return "the plate is over a hole";
    }
  // A hole that the whole plate covers meets none of those points.
  for (const auto& hole : face.holes)
    for (const truss::Vector2d& vertex : hole) {
      const Vector3d at = placed.frame.inverse() * (face.frame * Vector3d(vertex.x(), vertex.y(), 0.0));
      if (at.head<2>().cwiseAbs().maxCoeff() < 0.5 * model.plate.x() - allowed.overhang) return "the plate covers a hole";
    }
  for (std::size_t k = 0; k < 8; ++k)
    if (walk.step.after.joints[k] < model.mechanism.shortest() - allowed.limits ||
        walk.step.after.joints[k] > model.mechanism.longest() + allowed.limits)
      return "an actuator is beyond its limits";
  return collision_in(truss, placed_at(is.bodies, held), allowed);
}

// Of samples in the order in which the foot leaves the surface (or, backwards, meets it).
std::string off_the_line(const std::vector<Isometry3d>& soles, const Isometry3d& contact, const Bounds& allowed) {
  for (const Isometry3d& sole : soles) {
    const Isometry3d is = contact.inverse() * sole;
    if (is.translation().z() >= allowed.lift) return "";
    const double aside = is.translation().head<2>().norm(), turned = AngleAxisd(is.linear()).angle();
    if (aside > allowed.line || turned > allowed.line) return "off the normal by " + std::to_string(std::max(aside, turned));
  }
  return "";
}

}  // namespace

Chain chain_by_the_paper(const Model& model, const std::vector<double>& joints, Foot holds) {
  const bool a_holds = holds == Foot::kA;
  std::array<PaperLeg, 2> leg;
  for (std::size_t j = 0; j < 2; ++j) {
    const std::size_t k = (j == 0) == a_holds ? 0 : 4;
    leg[j] = leg_of(model, solved(model, joints[k], joints[k + 1]), solved(model, joints[k + 2], joints[k + 3]));
  }
  // From A the chain is as printed; from B it is the inverse of that, so both hip axes are met in the other order.
  const double to_a = joints[8], to_b = joints[9];
  const Isometry3d across = Isometry3d(AngleAxisd(to_a, Vector3d::UnitY())) * Translation3d(model.hip_distance, 0.0, 0.0) *
                            AngleAxisd(-to_b, Vector3d::UnitY());
  const Isometry3d over = a_holds ? across : across.inverse();
  const Isometry3d half = Isometry3d(AngleAxisd(to_a, Vector3d::UnitY())) * Translation3d(0.5 * model.hip_distance, 0.0, 0.0);
  const Isometry3d wire = to_wire();
  Chain out;
  out.sole[0] = Isometry3d::Identity();
  const Isometry3d other_sole = leg[0].hip * over * leg[1].hip.inverse();
  out.sole[1] = wire * other_sole * wire.inverse();
  const Isometry3d base = a_holds ? Isometry3d(leg[0].hip * half) : Isometry3d(leg[0].hip * over * half);
  out.base = wire * base * wire.inverse();
  const std::array<Isometry3d, 2> root{Isometry3d::Identity(), other_sole};
  for (std::size_t j = 0; j < 2; ++j) {
    const double thick = model.plate.z() - model.skin;
    out.bodies.plate[j].half = 0.5 * Vector3d(model.plate.x(), model.plate.y(), thick);
    out.bodies.plate[j].pose = out.sole[j] * Translation3d(0.0, 0.0, model.skin + 0.5 * thick);
    out.bodies.leg[j] = {wire * (root[j] * leg[j].ankle * Vector3d(0.0, model.leg_begin, 0.0)),
                         wire * (root[j] * leg[j].pin.translation()), model.leg_radius};
  }
  out.bodies.hip = {out.base, 0.5 * model.hip_plate};
  return out;
}

std::string densely_judged(const Model& model, const truss::Truss& truss, const CheckOptions& options, const Walk& walk, Foot holds,
                           const Allowance& allowance) {
  const Bounds allowed = bounds_of(options, allowance.sharp);
  if (std::string wrong = stand_in(model, truss, walk, holds, allowed); !wrong.empty()) return wrong;
  const std::vector<MotionPoint>& motion = walk.step.motion;
  const Isometry3d held = walk.before.stance[0].frame;
  std::vector<Isometry3d> soles;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    for (std::size_t j = 0; j < kJoints; ++j) {
      if (j < 8 && (motion[k].joints[j] < model.mechanism.shortest() - allowed.limits ||
                    motion[k].joints[j] > model.mechanism.longest() + allowed.limits))
        return "an actuator is beyond its limits on the way";
      if (k > 0 && std::fabs(motion[k].joints[j] - motion[k - 1].joints[j]) >
                       allowed.speed * (j < 8 ? model.actuator_speed : model.hip_speed) * (motion[k].time - motion[k - 1].time))
        return "a joint is too fast";
    }
    if (apart_by(held * chain_by_the_paper(model, motion[k].joints, holds).base, motion[k].base) > allowed.pose)
      return "a base on the way is elsewhere";
    if (k == 0) continue;
    for (int sample = 0; sample <= allowance.samples; ++sample) {
      std::vector<double> joints(kJoints);
      const double part = static_cast<double>(sample) / allowance.samples;
      for (std::size_t j = 0; j < kJoints; ++j) joints[j] = (1.0 - part) * motion[k - 1].joints[j] + part * motion[k].joints[j];
      const Chain is = chain_by_the_paper(model, joints, holds);
      if (std::string wrong = collision_in(truss, placed_at(is.bodies, held), allowed); !wrong.empty()) return wrong;
      soles.push_back(held * is.sole[1]);
    }
  }
  for (std::size_t j = 0; j < kJoints && !motion.empty(); ++j) {
    if (std::fabs(motion.front().joints[j] - walk.before.joints[j]) > 1e-6) return "the motion begins elsewhere";
    if (std::fabs(std::remainder(motion.back().joints[j] - walk.step.after.joints[j], 2.0 * std::numbers::pi)) > 1e-6)
      return "the motion ends elsewhere";
  }
  if (std::string wrong = off_the_line(soles, walk.before.stance[1].frame, allowed); !wrong.empty()) return wrong;
  return off_the_line({soles.rbegin(), soles.rend()}, walk.step.placed[0].frame, allowed);
}

}  // namespace foothold::hyrecro
