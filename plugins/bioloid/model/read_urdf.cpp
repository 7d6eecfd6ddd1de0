// URDF by urdfdom to a model: the tree from its root, fixed joints joined, frames turned parallel to the torso.
#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <cmath>
#include <mutex>
#include <optional>
#include <set>

#include "bioloid/model/structure.hpp"
#include "bioloid/model/urdf.hpp"
#include "foothold/errors.hpp"

namespace foothold::bioloid {
namespace {

constexpr double kExact = 1e-6;  // m and 1: to which frames have to be parallel and soles mirrored

// What urdfdom says while it reads, which it gives to no caller.
class Complaints : public console_bridge::OutputHandler {
 public:
  Complaints() : level_(console_bridge::getLogLevel()) {
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_ERROR);
    console_bridge::useOutputHandler(this);
  }
  ~Complaints() override {
    console_bridge::restorePreviousOutputHandler();
    console_bridge::setLogLevel(level_);
  }
  void log(const std::string& text, console_bridge::LogLevel, const char*, int) override {
    said += (said.empty() ? "" : "; ") + text;
  }
  std::string said;

 private:
  console_bridge::LogLevel level_;
};

urdf::ModelInterfaceSharedPtr parsed(const std::string& text) {
  static std::mutex one_at_a_time;  // the handler is the process'
  const std::scoped_lock lock(one_at_a_time);
  Complaints complaints;
  urdf::ModelInterfaceSharedPtr model;
  try {
    model = urdf::parseURDF(text);
  } catch (const std::exception& fault) {
    throw InvalidModel("urdf", std::string("cannot be read: ") + fault.what());
  }
  if (!model || !model->getRoot())
    throw InvalidModel("urdf", "cannot be read: " + (complaints.said.empty() ? std::string("it is no URDF") : complaints.said));
  return model;
}

Vector3d eigen(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Isometry3d eigen(const urdf::Pose& pose) {
  Isometry3d out = Isometry3d::Identity();
  out.translation() = eigen(pose.position);
  const urdf::Rotation& r = pose.rotation;
  out.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
  return out;
}

class Reader {
 public:
  explicit Reader(const std::string& text) : urdf_(parsed(text)) {
    visit(*urdf_->getRoot(), 0, Isometry3d::Identity(), Vector3d::Zero());
    for (std::size_t j = 0; j < kJoints; ++j)
      if (!found_[j]) throw InvalidModel(joint_entry(name_at(kJointNames, j)), "is missing");
    for (const Side side : {Side::kRight, Side::kLeft})
      if (!soles_[index_of(side)]) throw InvalidModel(joint_entry(side == Side::kRight ? "r_sole" : "l_sole"), "is missing");
    for (std::size_t body = 0; body < kBodies; ++body)
      if (moments_[body].norm() > 0.0) model_.bodies[body].centre_of_mass = moments_[body] / model_.bodies[body].mass;
    if (!(model_.mass() > 0.0)) throw InvalidModel("urdf", "has no link with a mass");
  }

  Model model() const { return model_; }

  void check_soles() const {
    const Vector3d right = *soles_[0], left = *soles_[1];
    if (!((Vector3d(right.x(), -right.y(), right.z()) - left).norm() < kExact))
      throw InvalidModel(joint_entry("l_sole"), "is not where r_sole mirrored is");
  }

 private:
  static std::string joint_entry(const std::string& name) { return "urdf.joint[" + name + "]"; }
  static std::string link_entry(const std::string& name) { return "urdf.link[" + name + "]"; }

  // `link` belongs to `body`; `at`: its frame in the body's, turned as in the zero pose; `zero`: the body's origin from the
  // torso's.
  void visit(const urdf::Link& link, std::size_t body, const Isometry3d& at, const Vector3d& zero) {
    if (!visited_.insert(&link).second) throw InvalidModel(link_entry(link.name), "must have one joint that carries it");
    Body& out = model_.bodies[body];
    if (out.name.empty()) out.name = link.name;
    if (link.inertial) {
      const double mass = link.inertial->mass;
      if (!(mass >= 0.0) || !std::isfinite(mass)) throw InvalidModel(link_entry(link.name), "must have a mass of 0 at least");
      out.mass += mass;
      moments_[body] += mass * (at * eigen(link.inertial->origin.position));
    }
    for (const auto& collision : link.collision_array) out.boxes.push_back(box(link.name, *collision, at));
    for (const auto& child : link.child_joints) {
      const urdf::LinkConstSharedPtr next = urdf_->getLink(child->child_link_name);
      const Isometry3d joint = at * eigen(child->parent_to_joint_origin_transform);
      if (child->type == urdf::Joint::FIXED) {
        if (const auto side = sole_of(child->name)) place_sole(*side, child->name, body, joint, zero);
        visit(*next, body, joint, zero);
      } else {
        const std::size_t index = read_joint(*child, body, joint);
        Isometry3d turned = joint;
        turned.translation().setZero();
        visit(*next, index + 1, turned, zero + joint.translation());
      }
    }
  }

  static std::optional<Side> sole_of(const std::string& name) {
    if (name == "r_sole") return Side::kRight;
    if (name == "l_sole") return Side::kLeft;
    return std::nullopt;
  }

  void place_sole(Side side, const std::string& name, std::size_t body, const Isometry3d& at, const Vector3d& zero) {
    if (body != leg_joint(side, 5) + 1)
      throw InvalidModel(joint_entry(name), "must be under the link that " + name_at(kJointNames, leg_joint(side, 5)) + " carries");
    if (!at.linear().isIdentity(kExact)) throw InvalidModel(joint_entry(name), "must be level in the zero pose, X to the toes");
    soles_[index_of(side)] = zero + at.translation();
    if (side == Side::kRight) model_.ankle_to_sole = at.translation();
  }

  std::size_t read_joint(const urdf::Joint& joint, std::size_t body, const Isometry3d& at) {
    const std::string entry = joint_entry(joint.name);
    std::size_t index = 0;
    while (index < kJoints && name_at(kJointNames, index) != joint.name) ++index;
    if (index == kJoints)
      throw InvalidModel(entry, std::string("is none of the robot's joints (") + kJointNames + ") and not fixed");
    if (joint.type != urdf::Joint::REVOLUTE) throw InvalidModel(entry, "must be revolute");
    if (joint.mimic) throw InvalidModel(entry, "must not mimic another");
    if (!joint.limits) throw InvalidModel(entry, "must have limits");
    JointModel& out = model_.joints[index];
    out.parent = static_cast<int>(body) - 1;
    out.origin = at.translation();
    out.axis = at.linear() * eigen(joint.axis).normalized();
    out.limits = {joint.limits->lower, joint.limits->upper};
    out.speed = joint.limits->velocity;
    found_[index] = true;
    return index;
  }

  static BodyBox box(const std::string& link, const urdf::Collision& collision, const Isometry3d& at) {
    if (!collision.geometry || collision.geometry->type != urdf::Geometry::BOX)
      throw InvalidModel(link_entry(link), "must collide as boxes");
    const Isometry3d pose = at * eigen(collision.origin);
    const Eigen::Matrix3d turned = pose.linear().cwiseAbs();
    // Quarter turns change the edges' order; others leave a box that is not parallel to its frame.
    if (!((turned - turned.array().round().matrix()).cwiseAbs().maxCoeff() < kExact))
      throw InvalidModel(link_entry(link), "must have boxes that are parallel to the torso in the zero pose");
    const Vector3d size = eigen(dynamic_cast<const urdf::Box&>(*collision.geometry).dim);
    if (!(size.minCoeff() > 0.0) || !size.allFinite()) throw InvalidModel(link_entry(link), "must have boxes with edges above 0");
    return {pose.translation(), 0.5 * (turned.array().round().matrix() * size)};
  }

  urdf::ModelInterfaceSharedPtr urdf_;
  Model model_;
  std::set<const urdf::Link*> visited_;  // urdfdom lets joints close a loop
  std::array<bool, kJoints> found_{};
  std::array<Vector3d, kBodies> moments_ = filled();
  std::array<std::optional<Vector3d>, 2> soles_;  // from the torso's origin

  static std::array<Vector3d, kBodies> filled() {
    std::array<Vector3d, kBodies> out;
    out.fill(Vector3d::Zero());
    return out;
  }
};

}  // namespace

Model read_urdf(const RobotModel& file) {
  for (const auto& [path, quantity] : file.quantities())
    if (path != "sole.size" && !path.starts_with("carrying."))
      throw InvalidModel(path, "cannot stand beside urdf, which says it: only sole.size and carrying can");
  const Reader reader(file.text("urdf"));
  Model out = reader.model();
  // Legs first: where they are at fault the soles are too.
  complete(out, "urdf.joint[*]");
  reader.check_soles();
  return out;
}

}  // namespace foothold::bioloid
