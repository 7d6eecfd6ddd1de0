#include "octopod/model/model.hpp"

#include "foothold/errors.hpp"

namespace foothold::octopod {
namespace {

double positive(const RobotModel& file, const char* path, const char* unit) {
  const double value = file.number(path, unit);
  if (!(value > 0)) throw InvalidModel(path, "must be above 0, is " + std::to_string(value));
  return value;
}

double not_negative(const RobotModel& file, const char* path, const char* unit) {
  const double value = file.number(path, unit);
  if (!(value >= 0)) throw InvalidModel(path, "must not be negative, is " + std::to_string(value));
  return value;
}

}  // namespace

Model Model::from_model(const RobotModel& file) {
  Model out;
  out.coxa = not_negative(file, "leg.coxa", "m");
  out.femur = positive(file, "leg.femur", "m");
  out.tibia = positive(file, "leg.tibia", "m");
  out.leg_radius = positive(file, "leg.radius", "m");
  out.foot = not_negative(file, "leg.foot", "m");
  if (out.foot >= out.tibia) throw InvalidModel("leg.foot", "must be shorter than the tibia");
  out.femur_mass = positive(file, "leg.femur_mass", "kg");
  out.tibia_mass = positive(file, "leg.tibia_mass", "kg");
  out.joint_speed = positive(file, "leg.joint_speed", "rad/s");
  out.foot_speed = positive(file, "leg.foot_speed", "m/s");
  const std::vector<double>& edges = file.numbers("body.edges", "m", 3);
  out.body = {edges[0], edges[1], edges[2]};
  if (!(out.body.minCoeff() > 0)) throw InvalidModel("body.edges", "must be above 0");
  const std::vector<double>& at = file.numbers("body.shoulders", "m", 2);
  if (!(at[0] > 0 && at[1] > 0)) throw InvalidModel("body.shoulders", "must be above 0");
  out.shoulders = {Vector3d(at[0], at[1], 0), Vector3d(at[0], -at[1], 0), Vector3d(-at[0], at[1], 0), Vector3d(-at[0], -at[1], 0)};
  out.body_mass = positive(file, "body.mass", "kg");
  out.neck = positive(file, "joint.neck", "m");
  out.neck_radius = positive(file, "joint.radius", "m");
  out.height = positive(file, "joint.height", "m");
  return out;
}

std::string limb(int leg) { return std::string(1, module_of(leg) == 0 ? 'A' : 'B') + std::to_string(leg % 4 + 1); }

}  // namespace foothold::octopod
