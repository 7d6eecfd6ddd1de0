// What a planner throws or reports when a request, a scene or a search fails: each with the field at fault and the reason.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace foothold {

// Why a plan ended short of its goal. The numbers are the 400s of idl/foothold.idl; 900 to 999 are the plugin's own.
enum class PlanError : std::uint16_t {
  kNone = 0,
  kNoPath = 401,
  kUnreachableGoal = 402,
  kUnstable = 403,
  kCollision = 404,
  kJointLimit = 405,
  kToleranceNotMet = 406,
  kSearchLimit = 408,
};

// The start, the goal or a combination of parameters cannot be planned for. `field` is a path such as "goal.base.position".
// Thrown by Planner::start() and Planner::plan().
class InvalidRequest : public std::runtime_error {
 public:
  InvalidRequest(std::string field, const std::string& message) : std::runtime_error(message), field_(std::move(field)) {}
  const std::string& field() const noexcept { return field_; }

 private:
  std::string field_;
};

// The scene cannot be used. `field` is a path inside the scene file such as "obstacles[2].polygon". Thrown by Planner::prepare().
class InvalidScene : public std::runtime_error {
 public:
  InvalidScene(std::string field, const std::string& message) : std::runtime_error(message), field_(std::move(field)) {}
  const std::string& field() const noexcept { return field_; }

 private:
  std::string field_;
};

// The robot's numbers are wrong or incomplete. `field` is a path inside config/robots/*.yaml. Thrown by a planner's constructor.
class InvalidModel : public std::runtime_error {
 public:
  InvalidModel(std::string field, const std::string& message) : std::runtime_error(message), field_(std::move(field)) {}
  const std::string& field() const noexcept { return field_; }

 private:
  std::string field_;
};

}  // namespace foothold
