// Both modules and the centre of mass.
#include "octopod/model/body.hpp"

namespace foothold::octopod {

Isometry3d rear(const Model& model, const Coordinates& at) {
  Isometry3d out;
  out.linear() = at.front.linear() * at.ball.toRotationMatrix();
  out.translation() = centre(model, at) - model.arm() * out.linear().col(0);
  out.makeAffine();
  return out;
}

std::array<Isometry3d, 2> modules(const Model& model, const Coordinates& at) { return {at.front, rear(model, at)}; }

Vector3d centre(const Model& model, const Coordinates& at) {
  return at.front.translation() - model.arm() * at.front.linear().col(0);
}

Vector3d centre_of_mass(const Model& model, const Coordinates& at) {
  const auto poses = modules(model, at);
  const double links = model.femur_mass + model.tibia_mass;
  Vector3d moment = Vector3d::Zero();
  for (std::size_t k = 0; k < 2; ++k) {
    Vector3d own = Vector3d::Zero();
    for (int i = 0; i < 4; ++i) {
      const int which = 4 * static_cast<int>(k) + i;
      const LegPoints at_leg = leg_in_module(model, which, at.legs[static_cast<std::size_t>(which)]);
      own += model.femur_mass / 2 * (at_leg.shoulder + at_leg.knee) + model.tibia_mass / 2 * (at_leg.knee + at_leg.foot);
    }
    moment += (model.body_mass + 4 * links) * poses[k].translation() + poses[k].linear() * own;
  }
  return moment / model.mass();
}

}  // namespace foothold::octopod
