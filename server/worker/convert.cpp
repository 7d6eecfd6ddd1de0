// Member by member; poses become position and unit quaternion.
#include "worker/convert.hpp"

#include <algorithm>
#include <cmath>

#include "text/text.hpp"

namespace foothold::server {
namespace {

// The kinds are numbered alike on both sides.
static_assert(static_cast<int>(Shape::Kind::kBox) == msg::BOX && static_cast<int>(Shape::Kind::kCapsule) == msg::CAPSULE &&
              static_cast<int>(Shape::Kind::kSphere) == msg::SPHERE && static_cast<int>(Shape::Kind::kPolygon) == msg::POLYGON);

Vector3d to_vector(const msg::Vector3& v) { return {v.x(), v.y(), v.z()}; }

Isometry3d to_isometry(const msg::Pose& pose) {
  const msg::Quaternion& q = pose.orientation();
  Isometry3d out = Isometry3d::Identity();
  out.translation() = to_vector(pose.position());
  // The request's check allows 1e-6 of length error: the rotation shall have none.
  out.linear() = Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()).normalized().toRotationMatrix();
  return out;
}

Contact to_contact(const msg::Contact& contact) { return {contact.limb(), to_isometry(contact.frame()), contact.face()}; }

Placement to_placement(const msg::Placement& placement) {
  Placement out;
  std::ranges::transform(placement.contacts(), std::back_inserter(out.contacts), to_contact);
  if (!placement.base().empty()) out.base = to_isometry(placement.base().front());
  out.any_orientation = placement.any_orientation();
  out.joints = placement.joints();
  return out;
}

msg::Vector3 to_message(const Vector3d& v) {
  msg::Vector3 out;
  out.x(v.x());
  out.y(v.y());
  out.z(v.z());
  return out;
}

msg::Pose to_message(const Isometry3d& pose) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(pose.linear()).normalized();
  msg::Pose out;
  out.position(to_message(Vector3d(pose.translation())));
  out.orientation().w(q.w());
  out.orientation().x(q.x());
  out.orientation().y(q.y());
  out.orientation().z(q.z());
  return out;
}

std::vector<msg::Contact> to_message(const std::vector<Contact>& contacts) {
  std::vector<msg::Contact> out(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    out[i].limb(contacts[i].limb);
    out[i].frame(to_message(contacts[i].frame));
    out[i].face(contacts[i].face);
  }
  return out;
}

bool finite(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
}

std::optional<std::string> unsound_text(const std::string& path, const std::string& text) {
  if (is_clean_text(text)) return std::nullopt;
  return path + " must be UTF-8 without control characters, is " + quoted(text);
}

std::optional<std::string> unsound_pose(const std::string& path, const Isometry3d& pose) {
  if (!pose.matrix().allFinite()) return path + " holds a number that is not finite";
  const double error = (pose.linear().transpose() * pose.linear() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (error > 1e-6 || pose.linear().determinant() < 0.0) return path + " is not a rotation (error " + std::to_string(error) + ")";
  return std::nullopt;
}

std::optional<std::string> unsound_contacts(const std::string& path, const std::vector<Contact>& contacts) {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::string here = path + "[" + std::to_string(i) + "]";
    if (auto fault = unsound_pose(here + ".frame", contacts[i].frame)) return fault;
    if (auto fault = unsound_text(here + ".limb", contacts[i].limb)) return fault;
    if (auto fault = unsound_text(here + ".face", contacts[i].face)) return fault;
  }
  return std::nullopt;
}

}  // namespace

Request to_request(const msg::PlanRequest& request, double budget_left) {
  return {.unit = request.unit(),
          .start = to_placement(request.start()),
          .goal = to_placement(request.goal()),
          .budget = budget_left,
          .seed = request.seed()};
}

RobotModel to_model(const frame::Load& load) {
  std::map<std::string, Quantity, std::less<>> quantities;
  for (const frame::ModelEntry& entry : load.model())
    quantities.insert_or_assign(entry.path(), Quantity{.values = entry.values(), .unit = entry.unit(), .source = entry.source()});
  std::map<std::string, std::string, std::less<>> texts;
  for (const frame::ModelText& text : load.texts()) texts.insert_or_assign(text.path(), text.text());
  return RobotModel(std::move(quantities), std::move(texts));
}

msg::Step to_message(const Step& step) {
  msg::Step out;
  out.label(step.label);
  out.placed(to_message(step.placed));
  out.stance(to_message(step.after.stance));
  out.base(to_message(step.after.base));
  out.joints(step.after.joints);
  out.motion().resize(step.motion.size());
  for (std::size_t i = 0; i < step.motion.size(); ++i) {
    out.motion()[i].time(step.motion[i].time);
    out.motion()[i].base(to_message(step.motion[i].base));
    out.motion()[i].joints(step.motion[i].joints);
  }
  out.attributes().resize(step.attributes.size());
  for (std::size_t i = 0; i < step.attributes.size(); ++i) {
    out.attributes()[i].name(step.attributes[i].name);
    out.attributes()[i].value(step.attributes[i].value);
  }
  out.cost(step.cost);
  return out;
}

std::vector<msg::Shape> to_message(const std::vector<Shape>& shapes) {
  std::vector<msg::Shape> out(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    out[i].kind(static_cast<msg::ShapeKind>(shapes[i].kind));
    out[i].body(shapes[i].body);
    out[i].pose(to_message(shapes[i].pose));
    out[i].size(to_message(shapes[i].size));
    for (const Vector3d& vertex : shapes[i].vertices) out[i].vertices().push_back(to_message(vertex));
  }
  return out;
}

std::vector<msg::Margin> to_message(const std::vector<Margin>& margins) {
  std::vector<msg::Margin> out(margins.size());
  for (std::size_t i = 0; i < margins.size(); ++i) {
    out[i].name(margins[i].name);
    out[i].value(margins[i].value);
    out[i].least(margins[i].least);
    out[i].unit(margins[i].unit);
  }
  return out;
}

std::optional<std::string> unsound_part(const Step& step) {
  if (!std::isfinite(step.cost)) return "cost is not finite";
  if (auto fault = unsound_text("label", step.label)) return fault;
  for (const Attribute& attribute : step.attributes) {
    if (auto fault = unsound_text("an attribute's name", attribute.name)) return fault;
    if (auto fault = unsound_text("attribute " + attribute.name, attribute.value)) return fault;
  }
  if (!finite(step.after.joints)) return "joints hold a number that is not finite";
  if (auto fault = unsound_pose("base", step.after.base)) return fault;
  if (auto fault = unsound_contacts("placed", step.placed)) return fault;
  if (auto fault = unsound_contacts("stance", step.after.stance)) return fault;
  for (std::size_t i = 0; i < step.motion.size(); ++i) {
    const std::string path = "motion[" + std::to_string(i) + "]";
    if (!std::isfinite(step.motion[i].time)) return path + ".time is not finite";
    if (!finite(step.motion[i].joints)) return path + ".joints hold a number that is not finite";
    if (auto fault = unsound_pose(path + ".base", step.motion[i].base)) return fault;
  }
  return std::nullopt;
}

std::optional<std::string> unsound_part(const std::vector<Shape>& shapes) {
  for (const Shape& shape : shapes) {
    if (auto fault = unsound_text("a shape's body", shape.body)) return fault;
    const std::string path = "the shape of body '" + shape.body + "'";
    if (shape.kind > Shape::Kind::kPolygon) return path + " is of no known kind";
    if (auto fault = unsound_pose(path, shape.pose)) return fault;
    if (!shape.size.allFinite()) return path + " has a size that is not finite";
    for (const Vector3d& vertex : shape.vertices)
      if (!vertex.allFinite()) return path + " has a vertex that is not finite";
  }
  return std::nullopt;
}

}  // namespace foothold::server
