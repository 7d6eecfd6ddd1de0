// See judge.hpp.
#include "judge.hpp"

#include <algorithm>
#include <filesystem>

#include "foothold/robot_file.hpp"
#include "worker/convert.hpp"
#include "worker/loader.hpp"
#include "worker/schema.hpp"

namespace foothold::faults {
namespace {

Isometry3d pose_of(const msg::Pose& pose) {
  const msg::Quaternion& q = pose.orientation();
  Isometry3d out = Isometry3d::Identity();
  out.translation() << pose.position().x(), pose.position().y(), pose.position().z();
  out.linear() = Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()).normalized().toRotationMatrix();
  return out;
}

std::vector<Contact> contacts_of(const std::vector<msg::Contact>& contacts) {
  std::vector<Contact> out;
  for (const msg::Contact& contact : contacts) out.push_back({contact.limb(), pose_of(contact.frame()), contact.face()});
  return out;
}

Step step_of(const msg::Step& message) {
  Step out;
  out.label = message.label();
  out.placed = contacts_of(message.placed());
  out.after = {pose_of(message.base()), message.joints(), contacts_of(message.stance())};
  for (const msg::MotionPoint& point : message.motion())
    out.motion.push_back({point.time(), pose_of(point.base()), point.joints()});
  for (const msg::Attribute& attribute : message.attributes()) out.attributes.push_back({attribute.name(), attribute.value()});
  out.cost = message.cost();
  return out;
}

}  // namespace

Judge::Judge(std::string plugins, std::string robots, std::string scenes)
    : plugins_(std::move(plugins)), robot_files_(std::move(robots)), scene_files_(std::move(scenes)) {}

bool Judge::knows(const std::string& robot) const { return std::filesystem::exists(robot_files_ + "/" + robot + ".yaml"); }

Judge::Robot& Judge::robot(const std::string& name) {
  Robot& out = robots_[name];
  if (out.plugin == nullptr) {
    out.plugin = &server::load_plugin(plugins_ + "/" + name + ".so");
    out.planner = {out.plugin->create(load_robot_model(robot_files_ + "/" + name + ".yaml")), out.plugin->destroy};
  }
  return out;
}

std::optional<std::string> Judge::refusal(const msg::PlanRequest& request, std::span<const msg::Bytes> steps) {
  Robot& is = robot(request.robot());
  const auto parameters = server::parse_parameters(is.plugin->info, request.parameters());
  auto& scene = is.scenes[request.scene_revision() + '\n' + parameters.prepare_key];
  if (!scene) {
    const std::string path = request.scene().empty() ? "" : scene_files_ + "/" + request.scene_revision() + ".yaml";
    scene = is.planner->prepare({request.scene(), request.scene_revision(), "yaml", path}, parameters.values);
  }
  Posture before = is.planner->start(server::to_request(request, request.budget()), parameters.values, *scene);
  for (std::size_t index = 0; index < steps.size(); ++index) {
    const auto message = msg::decode<msg::Step>(steps[index]);
    if (!message) return "step " + std::to_string(index) + " cannot be read";
    const Step step = step_of(*message);
    const StepVerdict verdict = is.planner->check(step, before, parameters.values, *scene);
    const std::string where = request.robot() + ", step " + std::to_string(index) + ": ";
    if (!verdict.accepted) return where + verdict.reason;
    for (const Margin& margin : verdict.margins)
      if (!(margin.value >= margin.least)) return where + margin.name + " is below its least";
    before = step.after;
  }
  return std::nullopt;
}

}  // namespace foothold::faults
