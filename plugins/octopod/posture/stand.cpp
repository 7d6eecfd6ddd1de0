// The octopod over a node: bodies, feet, legs, in the order of the paper's section 5.1.
#include <cmath>
#include <numbers>

#include "octopod/posture/apart.hpp"
#include "octopod/posture/near_ground.hpp"
#include "octopod/posture/pair.hpp"
#include "octopod/posture/posture.hpp"
#include "octopod/posture/start.hpp"

namespace foothold::octopod {
namespace {

constexpr double kFarthest = 0.5;  // of C's height: a robot that must move farther is not over its node any more

}  // namespace

Vector3d axis_of(const Vector3d& normal, int orientation) {
  constexpr double kSteep = 0.9;
  const Vector3d reference = std::abs(normal.x()) < kSteep ? Vector3d::UnitX() : Vector3d::UnitY();
  const Vector3d x = (reference - reference.dot(normal) * normal).normalized(), y = normal.cross(x);
  const double angle = orientation * 2 * std::numbers::pi / kOrientations;
  return std::cos(angle) * x + std::sin(angle) * y;
}

std::optional<Pair> bodies_over(const Model& model, const terrain::Surface& surface, const Vector3d& node, const Vector3d& normal,
                                int orientation) {
  const Vector3d axis = axis_of(normal, orientation);
  Pair pair;
  pair.joint = node + model.height * normal;
  for (const int module : {0, 1}) {
    const Vector3d middle = pair.joint + (module == 0 ? model.arm() : -model.arm()) * axis;
    int triangle = -1;
    if (const auto hit = surface.beneath(middle); hit && surface.terrain().ground[static_cast<std::size_t>(hit->triangle)])
      triangle = hit->triangle;
    else
      triangle = surface.nearest(middle).triangle;
    if (triangle < 0) return std::nullopt;
    const Vector3d& z = surface.terrain().normals[static_cast<std::size_t>(triangle)];
    const Vector3d x = (axis - axis.dot(z) * z).normalized();
    pair.turn[static_cast<std::size_t>(module)] << x, z.cross(x), z;
  }
  return pair;
}

Vector3d foot_in_the_air(const Model& model, const Pair& pair, int leg) {
  const Vector3d hanging(0, side(leg) * (model.coxa + model.femur), -model.tibia);
  return pair.joint + pair.turn[static_cast<std::size_t>(module_of(leg))] * (lever(model, leg) + hanging);
}

Hindrance complete(const Model& model, const terrain::Surface& surface, double clearance, bool legs_too, Built& built) {
  Standing& standing = built.standing;
  standing.rear = rear(model, standing.at);
  const std::array<Isometry3d, 2> modules{standing.at.front, standing.rear};
  std::array<LegPoints, kLegs> legs;
  Vector3d links = Vector3d::Zero();
  standing.residual = 0.0;
  for (int leg = 0; leg < kLegs; ++leg) {
    const auto i = static_cast<std::size_t>(leg);
    const LegPoints own = leg_in_module(model, leg, standing.at.legs[i]);
    const Isometry3d& module = modules[i / 4];
    legs[i] = {module * own.shoulder, module * own.knee, module * own.foot};
    links += model.femur_mass / 2 * (legs[i].shoulder + legs[i].knee) + model.tibia_mass / 2 * (legs[i].knee + legs[i].foot);
    standing.residual = std::max(standing.residual, (legs[i].foot - standing.feet[i].point).norm());
  }
  standing.centre_of_mass = (links + model.body_mass * (modules[0].translation() + modules[1].translation())) / model.mass();
  const Bodies bodies = bodies_of(model, modules, legs);
  const NearGround ground(surface, collision::grown(bounds_of(bodies), clearance));
  if (const auto touches = touching(ground, bodies, clearance)) {
    built.leg = *touches;
    built.figure = clearance;
    return built.hindrance = Hindrance::kCollision;
  }
  // All bodies hang together and none is cut, so one point tells on which side they are.
  if (surface.under(centre(model, standing.at))) {
    built.leg = -1;
    built.figure = clearance;
    return built.hindrance = Hindrance::kCollision;
  }
  std::optional<Touch> touch;
  if (legs_too)
    touch = touching_itself(model, modules, legs, clearance + kApart);
  else if (modules_nearer(model, modules, clearance))
    touch = Touch{kBodyOfA, kBodyOfB};
  if (touch) {
    built.leg = touch->part;
    built.other = touch->other;
    built.figure = legs_too ? clearance + kApart : clearance;
    return built.hindrance = Hindrance::kSelfContact;
  }
  return built.hindrance = Hindrance::kNone;
}

Built stand_with(const Model& model, const terrain::Surface& surface, Pair pair, double clearance) {
  Built out;
  std::array<Vector3d, kLegs> feet;
  for (int leg = 0; leg < kLegs; ++leg) {
    const auto i = static_cast<std::size_t>(leg);
    const terrain::Nearest nearest = surface.nearest(foot_in_the_air(model, pair, leg));
    if (nearest.triangle < 0) {
      out.hindrance = Hindrance::kNoGround;
      return out;
    }
    feet[i] = nearest.point;
    out.standing.feet[i] = {nearest.point, surface.terrain().normals[static_cast<std::size_t>(nearest.triangle)], nearest.triangle};
  }
  const Miss miss = settle(model, feet, kFarthest * model.height, pair);
  const std::optional<Coordinates> at = miss.leg < 0 ? reaching(model, pair, feet) : std::nullopt;
  if (!at) {
    out.hindrance = Hindrance::kOutOfReach;
    out.leg = miss.leg;
    out.figure = miss.by;
    return out;
  }
  out.standing.at = *at;
  complete(model, surface, clearance, true, out);
  return out;
}

Built stand(const Model& model, const terrain::Surface& surface, const Vector3d& node, const Vector3d& normal, int orientation,
            double clearance) {
  if (orientation >= kAxes) return turned(model, stand(model, surface, node, normal, orientation - kAxes, clearance));
  const std::optional<Pair> pair = bodies_over(model, surface, node, normal, orientation);
  if (!pair) return {.standing = {}, .hindrance = Hindrance::kNoGround, .leg = -1, .figure = 0.0};
  return stand_with(model, surface, *pair, clearance);
}

}  // namespace foothold::octopod
