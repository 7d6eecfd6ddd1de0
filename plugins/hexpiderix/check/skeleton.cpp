#include "hexpiderix/check/skeleton.hpp"

#include <numbers>

namespace foothold::hexpiderix {

Skeleton skeleton(const Model& model, const Isometry3d& base, std::span<const double> joints) {
  using Eigen::AngleAxisd;
  using Eigen::Translation3d;
  Skeleton out;
  Vector3d moment = model.thorax_mass * base.translation();
  double mass = model.thorax_mass;
  const auto weigh = [&](double kilograms, const Vector3d& at) {
    moment += kilograms * at;
    mass += kilograms;
  };
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    const Isometry3d turned = base * AngleAxisd(static_cast<double>(leg) * std::numbers::pi / 3, Vector3d::UnitZ());
    out.corners[leg] = turned * Vector3d(model.thorax_width / 2, 0, 0);
    const Isometry3d coxa = turned * Translation3d(model.thorax_radius, 0, 0) * Isometry3d::Identity();
    const Isometry3d hip =
        coxa * AngleAxisd(joints[3 * leg], Vector3d::UnitZ()) * Translation3d(model.leg.coxa, 0, -model.leg.drop);
    const Isometry3d knee = hip * AngleAxisd(-joints[3 * leg + 1], Vector3d::UnitY()) * Translation3d(model.leg.femur, 0, 0);
    const Isometry3d foot = knee * AngleAxisd(-joints[3 * leg + 2], Vector3d::UnitY()) * Translation3d(model.leg.tibia, 0, 0);
    out.limbs[leg] = {coxa.translation(), hip.translation(), knee.translation(), foot.translation()};
    for (const Vector3d& servo : {out.limbs[leg].coxa, out.limbs[leg].hip, out.limbs[leg].knee}) weigh(model.servo_mass, servo);
    weigh(model.femur_mass, 0.5 * (out.limbs[leg].hip + out.limbs[leg].knee));
    weigh(model.tibia_mass, 0.5 * (out.limbs[leg].knee + out.limbs[leg].foot));
  }
  out.centre_of_mass = moment / mass;
  return out;
}

}  // namespace foothold::hexpiderix
