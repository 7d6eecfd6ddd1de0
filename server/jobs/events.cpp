// Events for clients.
#include "jobs/events.hpp"

#include <chrono>
#include <cstring>

#include "foothold/msg/errors.hpp"
#include "jobs/admission/admission.hpp"
#include "jobs/admission/limits.hpp"
#include "text/text.hpp"

namespace foothold::server {

msg::PlanEvent change_event(const Speaker& speaker, const msg::PlanRequest& request, msg::State state, Stamp stamp,
                            std::uint32_t steps, msg::Error error) {
  msg::PlanEvent event;
  event.request(request.id());
  event.client(request.client());
  event.server(speaker.server);
  event.robot(request.robot());
  event.unit(request.unit());
  event.state(state);
  event.stamp(stamp);
  event.steps(steps);
  event.error(std::move(error));
  return event;
}

msg::PlanEvent as_answer(msg::PlanEvent event) {
  event.answer(true);
  return event;
}

msg::PlanEvent unknown_event(const Speaker& speaker, const Id& request, const Id& client, Stamp stamp, msg::Error error) {
  msg::PlanRequest asked;
  asked.id(request);
  asked.client(client);
  return as_answer(change_event(speaker, asked, msg::UNKNOWN, stamp, 0, std::move(error)));
}

void complete_summary(msg::Summary& summary, const Speaker& speaker, const Job& job, const RobotStatus& robot) {
  summary.steps(job.steps);
  summary.queued(std::chrono::duration<double>(job.started - job.arrived).count());
  // A robot that is not in the configuration any more has left its request behind.
  static const msg::RobotInfo kGone;
  const msg::RobotInfo& info = robot.info ? *robot.info : kGone;
  summary.plugin(info.plugin());
  summary.plugin_version(info.plugin_version());
  summary.server_version(speaker.version);
  summary.robot(job.request.robot());
  summary.scene(job.request.scene());
  summary.scene_revision(job.request.scene_revision());
  summary.parameters(complete_parameters(job.request.parameters(), info.parameters()));
  summary.seed(job.request.seed());
}

void sign_step(const Speaker& speaker, Bytes& step) {
  constexpr std::size_t kServer = 4 + sizeof(Id);  // behind the encapsulation and the request
  if (step.size() >= kServer + sizeof(Id)) std::memcpy(step.data() + kServer, speaker.server.data(), sizeof(Id));
}

Ending ending_of(const RunEnd& end) {
  if (end.kind == RunEnd::Kind::kLost) return {msg::CRASHED, end.error};
  if (end.error.code() == msg::OUT_OF_MEMORY) return {msg::CRASHED, end.error};
  if (end.state == msg::SUCCEEDED || end.state == msg::PARTIAL || end.state == msg::FAILED) return {end.state, end.error};
  return {msg::FAILED, msg::make_error(msg::WORKER_PROTOCOL, "the planner ended as " + std::string(msg::state_name(end.state)) +
                                                                 " though nothing had told it to stop")};
}

msg::Error cancel_error(const msg::CancelRequest& cancel) {
  std::string message = "cancelled by client " + msg::to_hex(cancel.client());
  if (cancel.reason().size() > limits::kReason)
    message += " (its reason has " + std::to_string(cancel.reason().size()) + " octets and is left out)";
  else if (!is_clean_text(cancel.reason()))
    message += ": " + quoted(cancel.reason());
  else if (!cancel.reason().empty())
    message += ": " + cancel.reason();
  return msg::make_error(msg::CANCELLED_BY_CLIENT, message);
}

}  // namespace foothold::server
