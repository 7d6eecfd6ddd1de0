// From the entries of config/robots/bioloid.yaml: the torso and one side, which the other mirrors; or from a URDF that stands
// there.
#include "bioloid/model/model.hpp"

#include <cmath>
#include <numeric>

#include "bioloid/model/structure.hpp"
#include "bioloid/model/urdf.hpp"
#include "foothold/errors.hpp"

namespace foothold::bioloid {
namespace {

// Of one side, in the joints' order.
constexpr const char* kOneSide = "shoulder_pitch|shoulder_roll|elbow|hip_yaw|hip_roll|hip_pitch|knee|ankle_pitch|ankle_roll";
constexpr const char* kOneSidesBodies = "shoulder|upper_arm|forearm|hip_bracket|hip_block|thigh|shin|ankle_block|foot";

Vector3d vector(const RobotModel& file, const std::string& path) {
  const std::vector<double>& v = file.numbers(path, "m", 3);
  return {v[0], v[1], v[2]};
}

Vector3d over(Side side, const Vector3d& v) { return side == Side::kRight ? v : Vector3d(v.x(), -v.y(), v.z()); }

double positive(const RobotModel& file, const std::string& path, const char* unit) {
  const double value = file.number(path, unit);
  if (!(value > 0.0)) throw InvalidModel(path, "must be above 0");
  return value;
}

void read_body(const RobotModel& file, const std::string& path, Side side, Body& body) {
  body.mass = positive(file, path + ".mass", "kg");
  body.centre_of_mass = over(side, vector(file, path + ".centre_of_mass"));
  for (const char* box : {".box", ".head"}) {
    if (!file.has(path + box + ".size")) continue;
    const Vector3d size = vector(file, path + box + ".size");
    if (!(size.minCoeff() > 0.0)) throw InvalidModel(path + box + ".size", "must be above 0");
    body.boxes.push_back({over(side, vector(file, path + box + ".centre")), 0.5 * size});
  }
}

JointModel read_joint(const RobotModel& file, std::size_t index, Side side) {
  const std::string path = "joint." + name_at(kOneSide, index);
  JointModel out;
  out.parent = index == 0 || index == 3 ? -1 : static_cast<int>(2 * (index - 1) + index_of(side));
  out.origin = over(side, vector(file, path + ".origin"));
  const std::vector<double>& axis = file.numbers(path + ".axis", "1", 3);
  out.axis = Vector3d(axis[0], axis[1], axis[2]);
  const std::vector<double>& limits = file.numbers(path + ".limits", "rad", 2);
  out.limits = {limits[0], limits[1]};
  if (side == Side::kLeft && mirrored(out, 1.0) < 0.0) out.limits = {-limits[1], -limits[0]};
  out.speed = file.number(index < 3 ? "speed.arm" : "speed.leg", "rad/s");
  return out;
}

}  // namespace

std::string name_at(const char* names, std::size_t index) {
  const std::string all = names;
  std::size_t begin = 0;
  for (; index > 0; --index) begin = all.find('|', begin) + 1;
  return all.substr(begin, all.find('|', begin) - begin);
}

double mirrored(const JointModel& joint, double angle) { return std::abs(joint.axis.y()) > 0.5 ? angle : -angle; }

double Model::mass() const {
  return std::accumulate(bodies.begin(), bodies.end(), 0.0, [](double sum, const Body& body) { return sum + body.mass; });
}

Vector3d Model::sole(Side side) const { return over(side, ankle_to_sole); }

namespace {

Model from_numbers(const RobotModel& file) {
  Model out;
  out.bodies[0].name = "torso";
  read_body(file, "torso", Side::kRight, out.bodies[0]);
  for (std::size_t i = 0; i < kJoints / 2; ++i)
    for (const Side side : {Side::kRight, Side::kLeft}) {
      const std::size_t j = 2 * i + index_of(side);
      out.joints[j] = read_joint(file, i, side);
      const std::string body = name_at(kOneSidesBodies, i);
      out.bodies[j + 1].name = (side == Side::kRight ? "r_" : "l_") + body;
      read_body(file, body, side, out.bodies[j + 1]);
    }
  out.ankle_to_sole = vector(file, "sole.centre");
  complete(out, "joint.*");
  return out;
}

}  // namespace

Model Model::from_model(const RobotModel& file) {
  Model out = file.has_text("urdf") ? read_urdf(file) : from_numbers(file);
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = file.number("carrying." + name_at(kOneSide, i), "rad");
    for (const std::size_t j : {2 * i, 2 * i + 1}) {
      const double held = j % 2 == 0 ? angle : mirrored(out.joints[j], angle);
      if (!out.joints[j].limits.holds(held))
        throw InvalidModel("carrying." + name_at(kOneSide, i), "is outside the limits of " + name_at(kJointNames, j));
      out.carrying[static_cast<int>(j)] = held;
    }
  }
  const std::vector<double>& sole = file.numbers("sole.size", "m", 2);
  if (!(sole[0] > 0.0 && sole[1] > 0.0)) throw InvalidModel("sole.size", "must be above 0");
  out.sole_length = sole[0];
  out.sole_width = sole[1];
  return out;
}

}  // namespace foothold::bioloid
