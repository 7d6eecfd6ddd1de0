// Rotations one after the other, and the sum of the links' moments.
#include "octopod/check/skeleton.hpp"

#include <numbers>

namespace foothold::octopod {
namespace {

Isometry3d turn(double angle, const Vector3d& axis) { return Isometry3d(Eigen::AngleAxisd(angle, axis)); }
Isometry3d ahead(double way) { return Isometry3d(Eigen::Translation3d(way, 0.0, 0.0)); }

}  // namespace

Skeleton skeleton(const Model& model, const Isometry3d& base, std::span<const double> joints) {
  Skeleton out;
  const Isometry3d at_joint = base * ahead(-model.neck - model.body.x() / 2);
  const Isometry3d ball =
      turn(joints[26], Vector3d::UnitZ()) * turn(joints[25], Vector3d::UnitY()) * turn(joints[24], Vector3d::UnitX());
  out.module = {base, at_joint * ball * ahead(-model.neck - model.body.x() / 2)};
  out.joint = at_joint.translation();
  Vector3d moment = model.body_mass * (out.module[0].translation() + out.module[1].translation());
  for (std::size_t k = 0; k < kLegs; ++k) {
    const double* q = &joints[3 * k];
    // The leg's X looks out to its side, then forwards by q1; what lifts turns about -Y.
    const double left = k % 2 == 0 ? 1.0 : -1.0;
    const Isometry3d hip = out.module[k / 4] * Isometry3d(Eigen::Translation3d(model.shoulders[k % 4])) *
                           turn(left * (std::numbers::pi / 2 - q[0]), Vector3d::UnitZ()) * ahead(model.coxa);
    const Isometry3d knee = hip * turn(-q[1], Vector3d::UnitY()) * ahead(model.femur);
    const Isometry3d tibia = knee * turn(-q[2], Vector3d::UnitY());
    Skeleton::Limb& limb = out.limbs[k];
    limb.hip = hip.translation();
    limb.knee = knee.translation();
    limb.ankle = tibia * Vector3d(model.tibia - model.foot, 0.0, 0.0);
    limb.foot = tibia * Vector3d(model.tibia, 0.0, 0.0);
    moment += model.femur_mass * 0.5 * (limb.hip + limb.knee) + model.tibia_mass * 0.5 * (limb.knee + limb.foot);
  }
  out.centre_of_mass = moment / model.mass();
  return out;
}

}  // namespace foothold::octopod
