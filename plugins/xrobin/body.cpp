// Bodies and pistons in a posture.
#include "body.hpp"

#include "foothold/errors.hpp"

namespace foothold::xrobin {
namespace {

Block block(const RobotModel& model, const std::string& name) {
  const std::vector<double>& half = model.numbers(name + ".half_extents", "m", 2);
  const Block out{half[0], half[1], model.number(name + ".height", "m")};
  if (!(out.half_x > 0.0 && out.half_y > 0.0)) throw InvalidModel(name + ".half_extents", "must be greater than 0");
  if (!(out.height > 0.0)) throw InvalidModel(name + ".height", "must be greater than 0");
  return out;
}

Eigen::Vector2d point(const PlanarPose& body, double x, double y) {
  const PlanarPose at = body * PlanarPose{x, y, 0.0};
  return {at.x, at.y};
}

Shape box(const char* name, const Block& block, const PlanarPose& pose) {
  Shape shape{Shape::Kind::kBox, name, to_world(pose), {2.0 * block.half_x, 2.0 * block.half_y, block.height}, {}};
  shape.pose.translation().z() = 0.5 * block.height;
  return shape;
}

Shape capsule(const char* name, const PistonAxis& axis, double radius, double height) {
  const Vector3d along(axis.on_b.x() - axis.on_a.x(), axis.on_b.y() - axis.on_a.y(), 0.0);
  const Eigen::Vector2d middle = 0.5 * (axis.on_a + axis.on_b);
  Shape shape{Shape::Kind::kCapsule, name, Isometry3d::Identity(), {radius, 0.0, along.norm()}, {}};
  shape.pose.translate(Vector3d(middle.x(), middle.y(), height));
  shape.pose.rotate(Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), along));
  return shape;
}

}  // namespace

Bodies Bodies::from_model(const RobotModel& model, const Mechanism& mechanism) {
  Bodies bodies{block(model, "body_a"), block(model, "body_b"), model.number("piston.radius", "m")};
  if (!(bodies.piston_radius > 0.0)) throw InvalidModel("piston.radius", "must be greater than 0");
  if (bodies.a.half_x < mechanism.lengths().b)
    throw InvalidModel("body_a.half_extents", "the pins at +-slot.half_width are outside");
  if (bodies.a.half_y < mechanism.travel()) throw InvalidModel("body_a.half_extents", "the slot is longer than the body");
  if (bodies.b.half_x < mechanism.lengths().p)
    throw InvalidModel("body_b.half_extents", "the pins at +-rail.half_width are outside");
  return bodies;
}

std::array<PistonAxis, 2> piston_axes(const Lengths& n, const BodyPoses& bodies) {
  return {{{point(bodies.a, -n.b, 0.0), point(bodies.b, n.p, 0.0)}, {point(bodies.a, n.b, 0.0), point(bodies.b, -n.p, 0.0)}}};
}

std::vector<Shape> solids(const Bodies& bodies, const Lengths& lengths, const BodyPoses& poses) {
  const auto axes = piston_axes(lengths, poses);
  const double above = std::max(bodies.a.height, bodies.b.height) + bodies.piston_radius;
  return {box("A", bodies.a, poses.a), box("B", bodies.b, poses.b), capsule("piston l", axes[0], bodies.piston_radius, above),
          capsule("piston r", axes[1], bodies.piston_radius, above)};
}

}  // namespace foothold::xrobin
