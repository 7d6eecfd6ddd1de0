// A request against the server's robots and scenes.
#include "jobs/admission/admission.hpp"

#include "foothold/msg/errors.hpp"
#include "jobs/admission/limits.hpp"
#include "text/text.hpp"

namespace foothold::server {

msg::Error refuse(std::uint16_t code, const std::string& field, const std::string& reason) {
  return msg::make_error(code, field + " " + reason, field);
}

Refusal check_robot(const std::string& robot, const RobotStatus& status) {
  if (!status.info) return refuse(msg::UNKNOWN_ROBOT, "robot", quoted(robot) + " is not a robot of this server");
  if (status.info->state() == msg::READY) return {};
  const bool quarantined = status.info->state() == msg::QUARANTINED;
  auto error = refuse(quarantined ? msg::ROBOT_QUARANTINED : msg::ROBOT_UNAVAILABLE, "robot",
                      quoted(robot) + (quarantined ? " is quarantined: " : " is not available: ") + status.info->reason());
  error.retry_after(status.retry_after);
  return error;
}

Refusal check_scene(msg::PlanRequest& request, const SceneShelf& scenes) {
  if (request.scene().empty()) return {};
  if (!scenes.knows(request.scene()))
    return refuse(msg::UNKNOWN_SCENE, "scene", quoted(request.scene()) + " is not a scene of this server");
  const auto found = scenes.find(request.scene(), request.scene_revision());
  if (!found)
    return refuse(msg::UNKNOWN_REVISION, "scene_revision",
                  request.scene_revision() + " is not a stored revision of scene " + quoted(request.scene()));
  request.scene_revision(found->revision);
  return {};
}

Refusal admit(msg::PlanRequest& request, double budget_max, const RobotStatus& status, const SceneShelf& scenes) {
  if (auto fault = check_form(request, budget_max)) return fault;
  if (auto fault = check_robot(request.robot(), status)) return fault;
  if (auto fault = check_scene(request, scenes)) return fault;
  return check_parameters(request.parameters(), status.info->parameters());
}

msg::PlanRequest essence(const msg::PlanRequest& request) {
  const auto within = [](const std::string& text, std::size_t limit) {
    return text.size() <= limit && is_clean_text(text) ? text : std::string();
  };
  msg::PlanRequest kept;
  kept.id(request.id());
  kept.client(request.client());
  kept.robot(within(request.robot(), limits::kRobot));
  kept.unit(within(request.unit(), limits::kUnit));
  kept.scene(within(request.scene(), limits::kScene));
  return kept;
}

}  // namespace foothold::server
