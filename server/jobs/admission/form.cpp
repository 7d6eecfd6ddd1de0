// The form of a request: what can be judged without knowing robots, scenes or other requests.
#include <cmath>
#include <cstdio>

#include "jobs/admission/admission.hpp"
#include "jobs/admission/limits.hpp"
#include "text/text.hpp"

namespace foothold::server {
namespace {

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

Refusal check_text(const std::string& field, const std::string& text, std::size_t limit) {
  if (text.size() > limit)
    return refuse(msg::OVERSIZE, field,
                  "must have " + std::to_string(limit) + " octets at most, has " + std::to_string(text.size()));
  if (!is_clean_text(text)) return refuse(msg::MALFORMED, field, "must be UTF-8 without control characters, is " + quoted(text));
  return {};
}

Refusal check_count(const std::string& field, std::size_t count, std::size_t limit) {
  if (count <= limit) return {};
  return refuse(
      msg::OVERSIZE, field,
      "must have " + std::to_string(limit) + (limit == 1 ? " element" : " elements") + " at most, has " + std::to_string(count));
}

Refusal check_finite(const std::string& field, const char* member, double value) {
  if (std::isfinite(value)) return {};
  return refuse(msg::NOT_FINITE, field, std::string("must be finite, ") + member + "is " + shown(value));
}

Refusal check_pose(const std::string& path, const msg::Pose& pose) {
  const auto& p = pose.position();
  for (const auto& [member, value] : {std::pair{"x ", p.x()}, {"y ", p.y()}, {"z ", p.z()}})
    if (auto fault = check_finite(path + ".position", member, value)) return fault;
  const auto& q = pose.orientation();
  for (const auto& [member, value] : {std::pair{"w ", q.w()}, {"x ", q.x()}, {"y ", q.y()}, {"z ", q.z()}})
    if (auto fault = check_finite(path + ".orientation", member, value)) return fault;
  const double length = std::hypot(std::hypot(q.w(), q.x()), std::hypot(q.y(), q.z()));
  if (std::abs(length - 1.0) > limits::kUnitLength)
    return refuse(msg::NOT_UNIT, path + ".orientation", "must be a quaternion of length 1, has length " + shown(length));
  return {};
}

Refusal check_contact(const std::string& path, const msg::Contact& contact) {
  if (auto fault = check_text(path + ".limb", contact.limb(), limits::kLimb)) return fault;
  if (auto fault = check_pose(path + ".frame", contact.frame())) return fault;
  return check_text(path + ".face", contact.face(), limits::kFace);
}

Refusal check_placement(const std::string& path, const msg::Placement& placement) {
  if (auto fault = check_count(path + ".contacts", placement.contacts().size(), limits::kContacts)) return fault;
  for (std::size_t i = 0; i < placement.contacts().size(); ++i)
    if (auto fault = check_contact(path + ".contacts[" + std::to_string(i) + "]", placement.contacts()[i])) return fault;
  if (auto fault = check_count(path + ".base", placement.base().size(), limits::kBase)) return fault;
  for (const auto& base : placement.base())
    if (auto fault = check_pose(path + ".base", base)) return fault;
  if (auto fault = check_count(path + ".joints", placement.joints().size(), limits::kJoints)) return fault;
  for (std::size_t i = 0; i < placement.joints().size(); ++i)
    if (auto fault = check_finite(path + ".joints[" + std::to_string(i) + "]", "", placement.joints()[i])) return fault;
  return {};
}

Refusal check_scene_form(const msg::PlanRequest& request) {
  if (auto fault = check_text("scene", request.scene(), limits::kScene)) return fault;
  if (request.scene_revision().empty()) return {};
  if (!is_sha256_hex(request.scene_revision()))
    return refuse(msg::MALFORMED, "scene_revision",
                  "must be empty or 64 lower-case hexadecimal digits, is " + quoted(request.scene_revision()));
  if (request.scene().empty()) return refuse(msg::MALFORMED, "scene", "must be named when scene_revision is given, is empty");
  return {};
}

Refusal check_budget(double budget, double budget_max) {
  if (auto fault = check_finite("budget", "", budget)) return fault;
  if (budget > 0.0 && budget <= budget_max) return {};
  return refuse(msg::MALFORMED, "budget", "must be above 0 s and at most " + shown(budget_max) + " s, is " + shown(budget) + " s");
}

Refusal check_parameters_form(const std::vector<msg::Parameter>& parameters) {
  if (auto fault = check_count("parameters", parameters.size(), limits::kParameters)) return fault;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto& parameter = parameters[i];
    if (auto fault = check_text("parameters[" + std::to_string(i) + "].name", parameter.name(), limits::kParameterName))
      return fault;
    if (auto fault = check_text("parameters." + parameter.name(), parameter.value(), limits::kParameterValue)) return fault;
  }
  return {};
}

}  // namespace

Refusal check_form(const msg::PlanRequest& request, double budget_max) {
  if (request.id() == msg::kNoId) return refuse(msg::MALFORMED, "id", "must not be all zeros");
  if (request.client() == msg::kNoId) return refuse(msg::MALFORMED, "client", "must not be all zeros");
  if (auto fault = check_text("robot", request.robot(), limits::kRobot)) return fault;
  if (auto fault = check_text("unit", request.unit(), limits::kUnit)) return fault;
  if (auto fault = check_scene_form(request)) return fault;
  if (auto fault = check_placement("start", request.start())) return fault;
  if (auto fault = check_placement("goal", request.goal())) return fault;
  if (auto fault = check_budget(request.budget(), budget_max)) return fault;
  if (auto fault = check_parameters_form(request.parameters())) return fault;
  const std::size_t size = msg::PlanRequest::getCdrSerializedSize(request);
  if (size > limits::kRequest)
    return refuse(msg::OVERSIZE, "request",
                  "must have " + std::to_string(limits::kRequest) + " octets at most, has " + std::to_string(size));
  return {};
}

}  // namespace foothold::server
