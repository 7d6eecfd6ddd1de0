// Makes the events that clients are told: changes of state, answers, and the summary that final states carry.
#pragma once

#include <string>

#include "jobs/job.hpp"

namespace foothold::server {

// Who speaks.
struct Speaker {
  Id server{};
  std::string version;
};

// `job` changes to `state` at `stamp`. `steps` is the count of those sent before.
msg::PlanEvent change_event(const Speaker& speaker, const msg::PlanRequest& request, msg::State state, Stamp stamp,
                            std::uint32_t steps, msg::Error error);

// The same event as an answer: nothing changed.
msg::PlanEvent as_answer(msg::PlanEvent event);

// For an id that cannot be answered from memory or journal: state UNKNOWN and why.
msg::PlanEvent unknown_event(const Speaker& speaker, const Id& request, const Id& client, Stamp stamp, msg::Error error);

// Fills in what only the server knows of a plan that ran: counts, waiting time, names, versions, parameters with defaults, seed.
void complete_summary(msg::Summary& summary, const Speaker& speaker, const Job& job, const RobotStatus& robot);

// Writes the server's id into a step that a worker made: workers do not know whose they are. `step`: CDR of foothold::msg::Step.
void sign_step(const Speaker& speaker, Bytes& step);

// What a worker's report means for the request. Only for runs that nobody stopped: a decided ending goes before any report.
Ending ending_of(const RunEnd& end);

// "cancelled by <client>: <reason>"
msg::Error cancel_error(const msg::CancelRequest& cancel);

}  // namespace foothold::server
