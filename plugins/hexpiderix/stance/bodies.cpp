// Capsules of the legs, box of the thorax, and who is too near whom.
#include "hexpiderix/stance/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "collision/distance.hpp"

namespace foothold::hexpiderix {
namespace {

using Fault = Evaluation::Fault;
using collision::Capsule;

struct Leg {
  Vector3d hip, knee, ankle, foot;  // world
  Vector3d middle;                  // of a ball that holds the three
  double reach;                     // its radius
};

Leg leg_at(const Model& model, const Coordinates& at, std::size_t which) {
  const LegPoints points = leg_points(model, which, at.legs[which]);
  Leg out{at.thorax * points.hip, at.thorax * points.knee, at.thorax * ankle_of(model, points), at.thorax * points.foot, {}, {}};
  out.middle = (out.hip + out.knee + out.foot) / 3.0;
  out.reach = std::sqrt(std::max({(out.hip - out.middle).squaredNorm(), (out.knee - out.middle).squaredNorm(),
                                  (out.foot - out.middle).squaredNorm()})) +
              model.leg_radius;
  return out;
}

double between(const Model& model, const Leg& a, const Leg& b) {
  const Capsule femurs[2] = {{a.hip, a.knee, model.leg_radius}, {b.hip, b.knee, model.leg_radius}};
  const Capsule tibiae[2] = {{a.knee, a.foot, model.leg_radius}, {b.knee, b.foot, model.leg_radius}};
  return std::min({collision::distance(femurs[0], femurs[1]), collision::distance(femurs[0], tibiae[1]),
                   collision::distance(tibiae[0], femurs[1]), collision::distance(tibiae[0], tibiae[1])});
}

Contacting trouble_with_itself(const Model& model, const Coordinates& at, const std::array<Leg, kLegs>& legs, double clearance) {
  for (std::size_t i = 0; i < kLegs; ++i)
    for (std::size_t j = i + 1; j < kLegs; ++j) {
      const double reach = legs[i].reach + legs[j].reach + clearance;
      if ((legs[i].middle - legs[j].middle).squaredNorm() >= reach * reach) continue;
      const double distance = between(model, legs[i], legs[j]);
      if (distance < clearance) return {Fault::kLegOnLeg, i, j, distance};
    }
  const collision::Box thorax = thorax_box(model, at.thorax);
  for (std::size_t i = 0; i < kLegs; ++i) {
    const Capsule tibia{legs[i].knee, legs[i].foot, model.leg_radius};
    if (!collision::nearer(tibia, thorax, clearance)) continue;
    return {Fault::kLegOnThorax, i, i, collision::distance(tibia, thorax)};
  }
  return {};
}

}  // namespace

collision::Box thorax_box(const Model& model, const Isometry3d& thorax) {
  return {thorax, {model.thorax_width / 2, model.thorax_width * std::numbers::sqrt3 / 4, model.thorax_height / 2}};
}

Contacting nearest_trouble(const Model& model, const Coordinates& at, const Plane& ground, Legs supports, double clearance) {
  std::array<Leg, kLegs> legs;
  for (std::size_t i = 0; i < kLegs; ++i) {
    legs[i] = leg_at(model, at, i);
    double low = std::min({ground.above(legs[i].hip), ground.above(legs[i].knee), ground.above(legs[i].ankle)}) - model.leg_radius;
    if (!supports[i]) low = std::min(low, ground.above(legs[i].foot));
    // A foot raised to exactly the clearance has it.
    if (low < clearance - 1e-9) return {Fault::kLegOnGround, i, i, low};
  }
  const Vector3d down = -model.thorax_height / 2 * Vector3d::UnitZ();
  for (int corner = 0; corner < 6; ++corner) {
    const double angle = corner * std::numbers::pi / 3;
    const Vector3d vertex = model.thorax_width / 2 * Vector3d(std::cos(angle), std::sin(angle), 0.0) + down;
    const double above = ground.above(at.thorax * vertex);
    if (above < clearance) return {Fault::kThoraxOnGround, 0, 0, above};
  }
  return trouble_with_itself(model, at, legs, clearance);
}

Contacting trouble_with_itself(const Model& model, const Coordinates& at, double clearance) {
  std::array<Leg, kLegs> legs;
  for (std::size_t i = 0; i < kLegs; ++i) legs[i] = leg_at(model, at, i);
  return trouble_with_itself(model, at, legs, clearance);
}

}  // namespace foothold::hexpiderix
