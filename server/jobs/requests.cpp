// What clients send: requests, cancels, queries.
#include <algorithm>
#include <cmath>

#include "foothold/msg/errors.hpp"
#include "jobs/admission/admission.hpp"
#include "jobs/jobs.hpp"

namespace foothold::server {
namespace {

constexpr double kLeastWait = 0.05;  // s, of retry_after
constexpr double kMostWait = 60.0;

Duration seconds(double s) { return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(s)); }

}  // namespace

void Jobs::ask(const Id& request, const Id& client, std::optional<std::uint32_t> from_step) {
  urgent_ = true;
  outgoing_.emplace_back(Asked{request, client, from_step});
}

// Nothing if the journal cannot be read.
std::optional<bool> Jobs::known(const Id& id) {
  if (jobs_.contains(id) || unsaved_.contains(id)) return true;
  try {
    return ports_.journal.knows(id);
  } catch (const JournalError& error) {
    complain_(error.what());
    return std::nullopt;
  }
}

void Jobs::request(msg::PlanRequest request) {
  if (request.server() != msg::kNoId && request.server() != options_.server) return moved_on(request);
  ports_.outbox.open(request.client());
  if (request.id() == msg::kNoId) {
    push(request.id(), change_event(speaker_, essence(request), msg::REJECTED, ports_.clock.stamp(), 0,
                                    *check_form(request, options_.budget_max)));
    return;
  }
  const auto is_known = known(request.id());
  if (is_known && !*is_known) return take(std::move(request));
  if (const auto job = jobs_.find(request.id()); job != jobs_.end()) hear_word(job->second, request);
  ask(request.id(), request.client(), 0);
}

// P35. A request that this server has and that its client addresses to another.
void Jobs::moved_on(const msg::PlanRequest& request) {
  const auto found = jobs_.find(request.id());
  if (found == jobs_.end() || found->second.ended() || found->second.ending) return;
  Job& job = found->second;
  if (job.request.client() != request.client()) return;
  const Ending ending{msg::CANCELLED,
                      msg::make_error(msg::MOVED, "its client submitted it to server " + msg::to_hex(request.server()))};
  if (job.run)
    halt(job, ending);
  else
    finish(job, ending);
}

void Jobs::take(msg::PlanRequest request) {
  if (const auto cancel = early_cancels_.take(request.id(), ports_.clock.now()))
    return refuse_request(std::move(request), msg::CANCELLED, cancel_error(*cancel));
  if (stopping_)
    return refuse_request(std::move(request), msg::REJECTED, msg::make_error(msg::SERVER_STOPPING, "the server is being stopped"));
  const RobotStatus status = ports_.planners.status(request.robot());
  if (auto refusal = admit(request, options_.budget_max, status, ports_.scenes))
    return refuse_request(std::move(request), msg::REJECTED, std::move(*refusal));
  const bool at_once = can_start(request);
  if (!at_once)
    if (auto refusal = check_room(request)) return refuse_request(std::move(request), msg::REJECTED, std::move(*refusal));

  Job& job = add_job(std::move(request));
  if (at_once)
    start(job);
  else
    enqueue(job);
  write(job, [&] { ports_.journal.add_request(job.request, job.received); });
}

Job& Jobs::add_job(msg::PlanRequest request) {
  const Id id = request.id();
  Job& job = jobs_[id];
  job.request = std::move(request);
  job.received = ports_.clock.stamp();
  job.arrived = ports_.clock.now();
  job.deadline = job.arrived + seconds(job.request.budget());
  job.turn = turns_++;
  return job;
}

// A request that ends as it comes. Its whole may break every limit, so the journal keeps the essence only.
void Jobs::refuse_request(msg::PlanRequest request, msg::State state, msg::Error error) {
  Job& job = jobs_[request.id()];
  job.request = essence(request);
  job.received = ports_.clock.stamp();
  write(job, [&] { ports_.journal.add_request(job.request, job.received); });
  finish(job, {state, std::move(error)});
}

Refusal Jobs::check_room(const msg::PlanRequest& request) const {
  const AdmissionLimits& limits = options_.limits;
  std::string reason;
  if (queue_.of_client(request.client()) >= limits.queued_per_client)
    reason = std::to_string(limits.queued_per_client) + " requests of this client wait already, which is the limit for one client";
  else if (queue_.size() >= limits.queued)
    reason = std::to_string(limits.queued) + " requests wait already, which is this server's limit";
  else
    return std::nullopt;
  auto error = msg::make_error(msg::QUEUE_FULL, reason);
  error.retry_after(std::clamp(time_to_a_place(request), kLeastWait, kMostWait));
  return error;
}

// s until one of the requests that hold this one up leaves the queue, if plans last as long as the recent ones did. A place of the
// client's own becomes free when it has its next turn, one of anybody when the next plan ends.
double Jobs::time_to_a_place(const msg::PlanRequest& request) const {
  const auto at_least_one = [](std::size_t count) { return static_cast<double>(std::max<std::size_t>(1, count)); };
  if (queue_.of_client(request.client()) < options_.limits.queued_per_client) return mean_run_ / at_least_one(runs_.size());
  if (options_.limits.running_per_client != 0 && shares_.of(request.client()) >= options_.limits.running_per_client)
    return mean_run_ / at_least_one(shares_.of(request.client()));
  const RobotStatus status = ports_.planners.status(request.robot());
  const double rounds = at_least_one(queue_.clients(request.robot())) / at_least_one(status.info ? status.info->slots() : 1);
  return mean_run_ * std::ceil(rounds);
}

void Jobs::set_limits(const AdmissionLimits& limits) {
  options_.limits = limits;
  look_again_ = true;
}

void Jobs::cancel(const msg::CancelRequest& cancel) {
  ports_.outbox.open(cancel.client());
  const auto found = jobs_.find(cancel.id());
  if (found != jobs_.end() && !found->second.ended() && !found->second.ending) {
    Job& job = found->second;
    const Ending ending{msg::CANCELLED, cancel_error(cancel)};
    if (job.run)
      halt(job, ending);
    else
      finish(job, ending);
    return;
  }
  const auto is_known = known(cancel.id());
  if (is_known && !*is_known && cancel.id() != msg::kNoId) {
    const Time until = ports_.clock.now() + seconds(options_.cancel_memory);
    const bool kept = early_cancels_.remember(cancel.id(), until, cancel);
    auto error = msg::make_error(msg::UNKNOWN_REQUEST,
                                 kept ? "no such request yet; if it comes soon it is cancelled at once"
                                      : "no such request, and too many cancels wait for theirs: not remembered",
                                 "id");
    push(cancel.id(), unknown_event(speaker_, cancel.id(), cancel.client(), ports_.clock.stamp(), std::move(error)));
    return;
  }
  ask(cancel.id(), cancel.client(), std::nullopt);
}

void Jobs::query(const msg::StateQuery& query) {
  ports_.outbox.open(query.client());
  if (query.request() != msg::kNoId) ask(query.request(), query.client(), query.from_step());
}

}  // namespace foothold::server
