// Forward kinematics and the centre of mass.
#include "octopod/model/body.hpp"

#include <cmath>

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

LegPoints leg_in_module(const Model& model, int which, const Vector3d& joints) {
  const Vector3d& shoulder = model.shoulders[static_cast<std::size_t>(which % 4)];
  const double s1 = std::sin(joints[0]), c1 = side(which) * std::cos(joints[0]);
  const auto in_plane = [&](double out, double up) { return Vector3d(out * s1, out * c1, up); };
  const double femur_out = std::cos(joints[1]), femur_up = std::sin(joints[1]);
  const double tibia_out = std::cos(joints[1] + joints[2]), tibia_up = std::sin(joints[1] + joints[2]);
  const double knee_out = model.coxa + model.femur * femur_out, knee_up = model.femur * femur_up;
  return {shoulder + in_plane(model.coxa, 0), shoulder + in_plane(knee_out, knee_up),
          shoulder + in_plane(knee_out + model.tibia * tibia_out, knee_up + model.tibia * tibia_up)};
}

LegPoints leg(const Model& model, const Coordinates& at, int which) {
  const Isometry3d module = module_of(which) == 0 ? at.front : rear(model, at);
  const LegPoints own = leg_in_module(model, which, at.legs[static_cast<std::size_t>(which)]);
  return {module * own.shoulder, module * own.knee, module * own.foot};
}

Eigen::Matrix3d leg_jacobian(const Model& model, int which, const Vector3d& joints) {
  const double s1 = std::sin(joints[0]), c1 = std::cos(joints[0]), left = side(which);
  const double s2 = std::sin(joints[1]), c2 = std::cos(joints[1]);
  const double s23 = std::sin(joints[1] + joints[2]), c23 = std::cos(joints[1] + joints[2]);
  const double out = model.coxa + model.femur * c2 + model.tibia * c23;
  const double lower_out = -model.tibia * s23, lower_up = model.tibia * c23;
  const double whole_out = lower_out - model.femur * s2, whole_up = lower_up + model.femur * c2;
  Eigen::Matrix3d jacobian;
  jacobian.col(0) << out * c1, -left * out * s1, 0;
  jacobian.col(1) << whole_out * s1, left * whole_out * c1, whole_up;
  jacobian.col(2) << lower_out * s1, left * lower_out * c1, lower_up;
  return jacobian;
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
