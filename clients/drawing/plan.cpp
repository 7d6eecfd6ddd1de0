// From messages to geometry: every number, quaternion, size and polygon is looked at once, here.
#include "plan.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace foothold::drawing {
namespace {

constexpr double kFarthest = 1e9;            // m; beyond it doubles no longer tell a robot's parts apart
constexpr double kUnitSlack = 1e-3;          // of a quaternion's length
constexpr double kPlanarSlack = 1e-3;        // of a polygon's width, off its plane
constexpr std::size_t kMostVertices = 2000;  // ears are found in the square of their number

template <class... Parts>
[[noreturn]] void refuse(const std::string& field, const Parts&... parts) {
  std::ostringstream reason;
  (reason << ... << parts);
  throw InvalidDrawing(field, reason.str());
}

double number(double value, const std::string& field) {
  if (!std::isfinite(value)) refuse(field, "is not a finite number (", value, ")");
  if (std::abs(value) > kFarthest) refuse(field, "is ", value, ", beyond 1e9");
  return value;
}

Vector3d vector(const msg::Vector3& v, const std::string& field) {
  return {number(v.x(), field + ".x"), number(v.y(), field + ".y"), number(v.z(), field + ".z")};
}

Isometry3d pose(const msg::Pose& p, const std::string& field) {
  const auto& q = p.orientation();
  const std::string turn = field + ".orientation";
  const Eigen::Quaterniond rotation(number(q.w(), turn + ".w"), number(q.x(), turn + ".x"), number(q.y(), turn + ".y"),
                                    number(q.z(), turn + ".z"));
  if (std::abs(rotation.norm() - 1.0) > kUnitSlack) refuse(turn, "must be of unit length, has length ", rotation.norm());
  Isometry3d result = Isometry3d::Identity();
  result.translate(vector(p.position(), field + ".position"));
  result.rotate(rotation.normalized());
  return result;
}

std::vector<ConvexPiece> polygon(const std::vector<msg::Vector3>& vertices, const std::string& field) {
  if (vertices.size() < 3) refuse(field, "a polygon needs 3 vertices, has ", vertices.size());
  if (vertices.size() > kMostVertices) refuse(field, "a polygon may have ", kMostVertices, " vertices, has ", vertices.size());
  Points points;
  for (std::size_t i = 0; i < vertices.size(); ++i) points.push_back(vector(vertices[i], field + "[" + std::to_string(i) + "]"));
  const Vector3d normal = newell(points);
  double width = 0.0, off = 0.0;
  for (const Vector3d& p : points) {
    width = std::max(width, (p - points[0]).norm());
    if (normal.norm() > 0.0) off = std::max(off, std::abs(normal.normalized().dot(p - points[0])));
  }
  if (off > kPlanarSlack * width && normal.norm() > kPlanarSlack * width * width)
    refuse(field, "must be planar, a vertex lies ", off, " m off the plane");
  auto pieces = convex_pieces(points);
  if (pieces.empty()) refuse(field, "the outline crosses itself");
  return pieces;
}

Body body(const msg::Shape& shape, const std::string& field) {
  Body result;
  result.kind = shape.kind();
  result.name = shape.body();
  switch (shape.kind()) {
    case msg::POLYGON:
      result.pieces = polygon(shape.vertices(), field + ".vertices");
      return result;
    case msg::BOX:
    case msg::CAPSULE:
    case msg::SPHERE:
      result.pose = pose(shape.pose(), field + ".pose");
      result.size = vector(shape.size(), field + ".size");
      for (int axis = 0; axis < 3; ++axis)
        if (result.size[axis] < 0.0) refuse(field + ".size." + "xyz"[axis], "must not be below 0, is ", result.size[axis]);
      return result;
  }
  refuse(field + ".kind", "must be BOX, CAPSULE, SPHERE or POLYGON, is number ", static_cast<std::uint32_t>(shape.kind()));
}

std::vector<Body> bodies(const std::vector<msg::Shape>& shapes, const std::string& field) {
  std::vector<Body> result;
  for (std::size_t i = 0; i < shapes.size(); ++i) result.push_back(body(shapes[i], field + "[" + std::to_string(i) + "]"));
  return result;
}

std::vector<Foothold> footholds(const std::vector<msg::Contact>& contacts, const std::string& field) {
  std::vector<Foothold> result;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    result.push_back(
        {contacts[i].limb(), contacts[i].face(), pose(contacts[i].frame(), field + "[" + std::to_string(i) + "].frame")});
  return result;
}

Mark mark(const msg::Placement& placement, const std::string& field) {
  Mark result;
  result.contacts = footholds(placement.contacts(), field + ".contacts");
  if (placement.base().empty()) return result;
  // Where any orientation will do, clients may leave the quaternion as it is.
  if (placement.any_orientation())
    result.base = vector(placement.base()[0].position(), field + ".base.position");
  else
    result.base = pose(placement.base()[0], field + ".base").translation();
  return result;
}

Stance stance(const msg::Step& step, const std::string& field) {
  Stance result;
  result.index = step.index();
  result.label = step.label();
  result.placed = footholds(step.placed(), field + ".placed");
  result.holding = footholds(step.stance(), field + ".stance");
  for (std::size_t i = 0; i < step.motion().size(); ++i)
    result.base_way.push_back(pose(step.motion()[i].base(), field + ".motion[" + std::to_string(i) + "].base").translation());
  result.base_way.push_back(pose(step.base(), field + ".base").translation());
  result.bodies = bodies(step.shapes(), field + ".shapes");
  return result;
}

}  // namespace

Plan checked_plan(const Drawing& drawing, const DrawOptions& options) {
  Plan plan;
  plan.scene = bodies(drawing.scene, "scene");
  plan.start = mark(drawing.start, "start");
  plan.goal = mark(drawing.goal, "goal");
  std::optional<std::uint32_t> before;
  for (const msg::Step& step : drawing.steps) {
    if (before && step.index() <= *before) refuse("steps", "must rise by index, ", step.index(), " follows ", *before);
    before = step.index();
    if (options.first_step && step.index() < *options.first_step) continue;
    if (options.last_step && step.index() > *options.last_step) continue;
    plan.stances.push_back(stance(step, "steps[" + std::to_string(step.index()) + "]"));
  }
  if (plan.stances.empty() && !drawing.steps.empty())
    refuse("options.first_step", "none of the ", drawing.steps.size(), " steps, ", drawing.steps.front().index(), " to ",
           drawing.steps.back().index(), ", is among those asked for");
  if (plan.stances.empty() && plan.scene.empty() && plan.start.empty() && plan.goal.empty())
    refuse("", "there is nothing to draw: no step, no scene, neither start nor goal");
  return plan;
}

}  // namespace foothold::drawing
