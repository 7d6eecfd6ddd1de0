// What clients send: requests, cancels, queries.
#include <algorithm>

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
  if (request.server() != msg::kNoId && request.server() != options_.server) return;
  ports_.outbox.open(request.client());
  if (request.id() == msg::kNoId) {
    push(request.id(), change_event(speaker_, essence(request), msg::REJECTED, ports_.clock.stamp(), 0,
                                    *check_form(request, options_.budget_max)));
    return;
  }
  const auto is_known = known(request.id());
  if (!is_known || *is_known)
    ask(request.id(), request.client(), 0);
  else
    take(std::move(request));
}

void Jobs::take(msg::PlanRequest request) {
  if (const auto cancel = early_cancels_.take(request.id(), ports_.clock.now()))
    return refuse_request(std::move(request), msg::CANCELLED, cancel_error(*cancel));
  if (stopping_)
    return refuse_request(std::move(request), msg::REJECTED, msg::make_error(msg::SERVER_STOPPING, "the server is being stopped"));
  const RobotStatus status = ports_.planners.status(request.robot());
  if (auto refusal = admit(request, options_.budget_max, status, ports_.scenes))
    return refuse_request(std::move(request), msg::REJECTED, std::move(*refusal));
  const bool at_once = can_start(request.robot());
  if (!at_once && queue_.size() >= options_.queue_limit) return refuse_request(std::move(request), msg::REJECTED, queue_full());

  Job& job = add_job(std::move(request));
  if (at_once) {
    start(job);
  } else {
    queue_.add(job.request.robot(), job.request.priority(), job.turn, job.request.id());
    set_alarm(job, job.deadline);
    tell(job, msg::QUEUED, {});
  }
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

msg::Error Jobs::queue_full() const {
  auto error =
      msg::make_error(msg::QUEUE_FULL, std::to_string(queue_.size()) + " requests wait already, which is this server's limit");
  // A place becomes free when one of the running plans ends.
  error.retry_after(std::clamp(mean_run_ / static_cast<double>(std::max<std::size_t>(1, runs_.size())), kLeastWait, kMostWait));
  return error;
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
