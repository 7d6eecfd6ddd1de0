#include "hexpiderix/model/model.hpp"

namespace foothold::hexpiderix {

Model Model::from_model(const RobotModel& file) {
  Model out;
  out.thorax_radius = file.number("thorax.radius", "m");
  out.thorax_width = file.number("thorax.width", "m");
  out.thorax_height = file.number("thorax.height", "m");
  out.thorax_mass = file.number("thorax.mass", "kg");
  out.leg = {.coxa = file.number("leg.coxa", "m"),
             .drop = file.number("leg.drop", "m"),
             .femur = file.number("leg.femur", "m"),
             .tibia = file.number("leg.tibia", "m")};
  out.leg_radius = file.number("leg.radius", "m");
  out.toe = file.number("leg.toe", "m");
  out.lift = file.number("leg.lift", "m");
  out.femur_mass = file.number("leg.femur_mass", "kg");
  out.tibia_mass = file.number("leg.tibia_mass", "kg");
  out.servo_mass = file.number("leg.servo_mass", "kg");
  for (const int joint : {1, 2, 3}) {
    const std::vector<double>& range = file.numbers("joint.q" + std::to_string(joint), "rad", 2);
    out.limits[static_cast<std::size_t>(joint - 1)] = {range[0], range[1]};
  }
  out.joint_speed = file.number("joint.speed", "rad/s");
  return out;
}

double Model::mass() const { return thorax_mass + kLegs * (3 * servo_mass + femur_mass + tibia_mass); }

}  // namespace foothold::hexpiderix
