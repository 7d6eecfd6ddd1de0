// Balls round legs first, then balls round links, then links; modules' own frames rule out what lies beside them.
#include "octopod/posture/apart.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::octopod {
namespace {

using collision::Box;
using collision::Capsule;

struct Ball {
  Vector3d centre;
  double radius;
};

Ball ball_round(const LegPoints& leg) {
  const Vector3d centre = (leg.shoulder + leg.foot) / 2;
  return {centre, std::sqrt(std::max((leg.foot - centre).squaredNorm(), (leg.knee - centre).squaredNorm()))};
}

bool balls_nearer(const Ball& a, const Ball& b, double keep) {
  const double sum = a.radius + b.radius + keep;
  return (a.centre - b.centre).squaredNorm() < sum * sum;
}

Capsule neck_of(const Model& model, const Isometry3d& pose, int module) {
  const Vector3d forth = (module == 0 ? -1.0 : 1.0) * pose.linear().col(0);
  return {pose.translation() + model.body.x() / 2 * forth, pose.translation() + model.arm() * forth, model.neck_radius};
}

}  // namespace

bool legs_nearer(const Model& model, const LegPoints& a, const LegPoints& b, double clearance) {
  const double radius = model.leg_radius, keep = 2 * radius + clearance;
  // With a coxa the femur's capsule begins at the shoulder and is longer than the femur.
  const double upper = model.coxa + model.femur;
  const std::array<double, 2> lengths{upper, model.tibia};
  const std::array<Capsule, 2> of_a{{{a.shoulder, a.knee, radius}, {a.knee, a.foot, radius}}};
  const std::array<Capsule, 2> of_b{{{b.shoulder, b.knee, radius}, {b.knee, b.foot, radius}}};
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const Ball round_a{(of_a[i].a + of_a[i].b) / 2, lengths[i] / 2}, round_b{(of_b[j].a + of_b[j].b) / 2, lengths[j] / 2};
      if (balls_nearer(round_a, round_b, keep) && collision::nearer(of_a[i], of_b[j], clearance)) return true;
    }
  return false;
}

bool leg_nearer(const Model& model, const LegPoints& leg, int module, const Isometry3d& pose, bool own, double clearance) {
  const Vector3d& begin = own ? leg.knee : leg.shoulder;
  const auto seen = [&](const Vector3d& p) -> Vector3d { return pose.linear().transpose() * (p - pose.translation()); };
  const Vector3d a = seen(begin), b = seen(leg.knee), c = seen(leg.foot);
  // Body and neck lie in this box.
  Vector3d low = -model.body / 2, high = model.body / 2;
  const double thick = model.neck_radius;
  low = low.cwiseMin(Vector3d(0, -thick, -thick));
  high = high.cwiseMax(Vector3d(0, thick, thick));
  (module == 0 ? low.x() : high.x()) = (module == 0 ? -1.0 : 1.0) * (model.arm() + thick);
  const double keep = model.leg_radius + clearance;
  const Vector3d least = a.cwiseMin(b).cwiseMin(c), most = a.cwiseMax(b).cwiseMax(c);
  if (((least - high).array() > keep).any() || ((low - most).array() > keep).any()) return false;
  const Box body{pose, model.body / 2};
  const Capsule neck = neck_of(model, pose, module);
  const Capsule femur{leg.shoulder, leg.knee, model.leg_radius}, tibia{leg.knee, leg.foot, model.leg_radius};
  return collision::nearer(tibia, body, clearance) || collision::nearer(tibia, neck, clearance) ||
         (!own && (collision::nearer(femur, body, clearance) || collision::nearer(femur, neck, clearance)));
}

bool modules_nearer(const Model& model, const std::array<Isometry3d, 2>& modules, double clearance) {
  // Each module is on its side of the plane through C that halves the bend, by what its end's corners (or C's own ball) leave.
  const double straight = std::clamp(modules[0].linear().col(0).dot(modules[1].linear().col(0)), -1.0, 1.0);
  const double along = std::sqrt((1 + straight) / 2), across = std::sqrt((1 - straight) / 2);
  const double left = model.neck * along - model.body.tail<2>().norm() / 2 * across;
  if (left + std::min(left, -model.neck_radius) >= clearance) return false;
  const Box a{modules[0], model.body / 2}, b{modules[1], model.body / 2};
  return collision::nearer(a, b, clearance) || collision::nearer(neck_of(model, modules[0], 0), b, clearance) ||
         collision::nearer(neck_of(model, modules[1], 1), a, clearance);
}

std::optional<Touch> touching_itself(const Model& model, const std::array<Isometry3d, 2>& modules,
                                     const std::array<LegPoints, kLegs>& legs, double clearance) {
  std::array<Ball, kLegs> balls;
  for (std::size_t i = 0; i < kLegs; ++i) balls[i] = ball_round(legs[i]);
  for (std::size_t i = 0; i < kLegs; ++i)
    for (std::size_t j = i + 1; j < kLegs; ++j)
      if (balls_nearer(balls[i], balls[j], 2 * model.leg_radius + clearance) && legs_nearer(model, legs[i], legs[j], clearance))
        return Touch{static_cast<int>(i), static_cast<int>(j)};
  for (std::size_t i = 0; i < kLegs; ++i)
    for (std::size_t m = 0; m < 2; ++m)
      if (leg_nearer(model, legs[i], static_cast<int>(m), modules[m], i / 4 == m, clearance))
        return Touch{static_cast<int>(i), kBodyOfA + static_cast<int>(m)};
  if (modules_nearer(model, modules, clearance)) return Touch{kBodyOfA, kBodyOfB};
  return std::nullopt;
}

}  // namespace foothold::octopod
