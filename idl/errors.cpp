// The table of errors. A test reads foothold.idl and holds every constant of it against this table.
#include "foothold/msg/errors.hpp"

#include <algorithm>
#include <array>

namespace foothold::msg {
namespace {

constexpr std::array kKinds = {
    ErrorKind{SERVER_RESTARTED, "SERVER_RESTARTED", "server", "submit the request again under a new id, or with resume: true",
              true},
    ErrorKind{SERVER_STOPPING, "SERVER_STOPPING", "server", "submit it to another server or when this one is back", true},
    ErrorKind{QUEUE_FULL, "QUEUE_FULL", "queue", "wait as long as retry_after says, then submit again", true},
    ErrorKind{ROBOT_UNAVAILABLE, "ROBOT_UNAVAILABLE", "worker", "look at 'foothold robots' for why, and at the server's log", true},
    ErrorKind{ROBOT_QUARANTINED, "ROBOT_QUARANTINED", "worker",
              "its planner crashed repeatedly; wait as long as retry_after says and report the crash", true},
    ErrorKind{STORAGE_FAILED, "STORAGE_FAILED", "server", "free space in the server's state directory", true},
    ErrorKind{INTERNAL, "INTERNAL", "server", "report it with the server's log", false},
    ErrorKind{PLAN_DIFFERS, "PLAN_DIFFERS", "server", "the steps received stay valid: plan anew from where they lead to", true},
    ErrorKind{MALFORMED, "MALFORMED", "request", "correct the field and submit again", false},
    ErrorKind{UNKNOWN_ROBOT, "UNKNOWN_ROBOT", "request", "'foothold robots' lists what this server plans for", false},
    ErrorKind{UNKNOWN_PARAMETER, "UNKNOWN_PARAMETER", "request", "'foothold robots --parameters' lists what the planner takes",
              false},
    ErrorKind{PARAMETER_OUT_OF_RANGE, "PARAMETER_OUT_OF_RANGE", "request", "'foothold robots --parameters' tells the range", false},
    ErrorKind{NOT_FINITE, "NOT_FINITE", "request", "send finite numbers only", false},
    ErrorKind{NOT_UNIT, "NOT_UNIT", "request", "normalise the quaternion (w, x, y, z)", false},
    ErrorKind{OVERSIZE, "OVERSIZE", "request", "send less", false},
    ErrorKind{UNKNOWN_REQUEST, "UNKNOWN_REQUEST", "request",
              "check the id; old requests are forgotten after the journal's retention time", false},
    ErrorKind{CANCELLED_BY_CLIENT, "CANCELLED_BY_CLIENT", "request", "", false},
    ErrorKind{BUDGET_EXHAUSTED, "BUDGET_EXHAUSTED", "search", "give a larger budget or an easier request", true},
    ErrorKind{INVALID_START, "INVALID_START", "request", "correct the start", false},
    ErrorKind{INVALID_GOAL, "INVALID_GOAL", "request", "correct the goal", false},
    ErrorKind{MOVED, "MOVED", "request", "ask the server that has it now", false},
    ErrorKind{UNKNOWN_SCENE, "UNKNOWN_SCENE", "scene",
              "'foothold scene list' shows what is stored; 'foothold scene put FILE' stores", false},
    ErrorKind{UNKNOWN_REVISION, "UNKNOWN_REVISION", "scene", "'foothold scene list' shows the revisions", false},
    ErrorKind{SCENE_HASH_MISMATCH, "SCENE_HASH_MISMATCH", "scene", "send the file again", true},
    ErrorKind{SCENE_TOO_LARGE, "SCENE_TOO_LARGE", "scene", "simplify the scene or raise scenes.max_bytes", false},
    ErrorKind{SCENE_FORMAT, "SCENE_FORMAT", "scene", "use yaml, stl, obj or ply", false},
    ErrorKind{INVALID_SCENE, "INVALID_SCENE", "scene", "correct the scene's field and store it again", false},
    ErrorKind{SCENE_INCOMPLETE, "SCENE_INCOMPLETE", "scene", "send the missing pieces again", true},
    ErrorKind{NO_PATH, "NO_PATH", "search", "look at the scene: 'foothold draw'", false},
    ErrorKind{UNREACHABLE_GOAL, "UNREACHABLE_GOAL", "search", "choose a goal within reach", false},
    ErrorKind{UNSTABLE, "UNSTABLE", "search", "no stable posture leads on; see the message", false},
    ErrorKind{COLLISION, "COLLISION", "search", "see the message for what is in the way", false},
    ErrorKind{JOINT_LIMIT, "JOINT_LIMIT", "search", "see the message for the joint", false},
    ErrorKind{TOLERANCE_NOT_MET, "TOLERANCE_NOT_MET", "search", "allow a larger tolerance or more steps", false},
    ErrorKind{STEP_REFUSED, "STEP_REFUSED", "check",
              "the planner's search and its checker disagree: report it; the steps before are sound", false},
    ErrorKind{SEARCH_LIMIT, "SEARCH_LIMIT", "search", "raise the limit that the message names", false},
    ErrorKind{WORKER_CRASHED, "WORKER_CRASHED", "worker", "report it with the server's log; other requests are not touched", true},
    ErrorKind{WORKER_KILLED, "WORKER_KILLED", "worker", "the planner did not stop when told to: report it", true},
    ErrorKind{OUT_OF_MEMORY, "OUT_OF_MEMORY", "worker", "ask for less or raise the robot's memory limit", false},
    ErrorKind{PLUGIN_THREW, "PLUGIN_THREW", "worker", "report it with the server's log", false},
    ErrorKind{PLUGIN_REFUSED, "PLUGIN_REFUSED", "worker",
              "build the plugin against this server's headers; 'foothold plugin info FILE' tells more", false},
    ErrorKind{WORKER_PROTOCOL, "WORKER_PROTOCOL", "worker", "report it with the server's log", false},
};

}  // namespace

std::span<const ErrorKind> error_kinds() { return kKinds; }

Error make_error(std::uint16_t code, std::string message, std::string field) {
  Error error;
  error.code(code);
  error.message(std::move(message));
  error.field(std::move(field));
  const auto kind = std::ranges::find(kKinds, code, &ErrorKind::code);
  if (kind == kKinds.end()) return error;
  error.name(std::string(kind->name));
  error.stage(std::string(kind->stage));
  error.hint(std::string(kind->hint));
  error.retryable(kind->retryable);
  return error;
}

std::string_view state_name(State state) {
  switch (state) {
    case UNKNOWN:
      return "UNKNOWN";
    case QUEUED:
      return "QUEUED";
    case RUNNING:
      return "RUNNING";
    case SUCCEEDED:
      return "SUCCEEDED";
    case PARTIAL:
      return "PARTIAL";
    case FAILED:
      return "FAILED";
    case CANCELLED:
      return "CANCELLED";
    case EXPIRED:
      return "EXPIRED";
    case CRASHED:
      return "CRASHED";
    case REJECTED:
      return "REJECTED";
  }
  return "INVALID";
}

bool is_final(State state) { return state >= SUCCEEDED && state <= REJECTED; }

}  // namespace foothold::msg
