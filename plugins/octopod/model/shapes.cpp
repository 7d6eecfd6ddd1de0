// The octopod's bodies as shapes for drawing; collisions use the same boxes and capsules.
#include "octopod/model/body.hpp"

namespace foothold::octopod {
namespace {

// A capsule's frame has its axis along Z and its origin in the middle.
Shape capsule(std::string name, const Vector3d& from, const Vector3d& to, double radius) {
  Shape out;
  out.kind = Shape::Kind::kCapsule;
  out.body = std::move(name);
  out.pose.translation() = (from + to) / 2;
  out.pose.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), to - from).toRotationMatrix();
  out.size = {radius, 0.0, (to - from).norm()};
  return out;
}

}  // namespace

std::vector<Shape> shapes(const Model& model, const Coordinates& at) {
  std::vector<Shape> out;
  out.reserve(4 + 2 * kLegs);
  const auto poses = modules(model, at);
  const Vector3d joint = centre(model, at);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string name = k == 0 ? "A" : "B";
    Shape body;
    body.body = name + " body";
    body.pose = poses[k];
    body.size = model.body;
    out.push_back(body);
    const double end = (k == 0 ? -1.0 : 1.0) * model.body.x() / 2;
    out.push_back(capsule(name + " neck", poses[k] * Vector3d(end, 0, 0), joint, model.neck_radius));
  }
  for (int which = 0; which < kLegs; ++which) {
    const LegPoints points = leg(model, at, which);
    const Vector3d ankle = points.foot + (points.knee - points.foot) * (model.foot / model.tibia);
    out.push_back(capsule(limb(which) + " femur", points.shoulder, points.knee, model.leg_radius));
    out.push_back(capsule(limb(which) + " tibia", points.knee, ankle, model.leg_radius));
  }
  return out;
}

}  // namespace foothold::octopod
