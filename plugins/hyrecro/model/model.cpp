#include "hyrecro/model/model.hpp"

namespace foothold::hyrecro {

Model Model::from_model(const RobotModel& file) {
  Model out;
  const std::vector<double>& stroke = file.numbers("mechanism.stroke", "m", 2);
  out.mechanism =
      kinematics::PlanarMechanism(file.number("mechanism.base", "m"), file.number("mechanism.body", "m"), stroke[0], stroke[1]);
  out.core = file.number("mechanism.core", "m");
  out.hip_distance = file.number("hip.distance", "m");
  out.ankle_height = file.number("leg.ankle_height", "m");
  out.hip_drop = file.number("leg.hip_drop", "m");
  out.leg_radius = file.number("leg.radius", "m");
  out.leg_begin = file.number("leg.begin", "m");
  const std::vector<double>& plate = file.numbers("plate.edges", "m", 3);
  out.plate = {plate[0], plate[1], plate[2]};
  const std::vector<double>& hip = file.numbers("hip.plate", "m", 3);
  out.hip_plate = {hip[0], hip[1], hip[2]};
  out.skin = file.number("plate.skin", "m");
  out.actuator_speed = file.number("mechanism.speed", "m/s");
  out.hip_speed = file.number("hip.speed", "rad/s");
  out.grip_time = file.number("plate.grip_time", "s");
  return out;
}

}  // namespace foothold::hyrecro
