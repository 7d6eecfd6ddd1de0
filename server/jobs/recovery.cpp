// After a restart: what the journal holds as unfinished ends, or runs again if it asked for that.
#include <algorithm>

#include "foothold/msg/errors.hpp"
#include "jobs/admission/admission.hpp"
#include "jobs/jobs.hpp"

namespace foothold::server {
namespace {

Duration seconds(double s) { return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(s)); }

}  // namespace

void Jobs::recover() {
  for (Record& record : ports_.journal.unfinished()) resume(std::move(record));
}

void Jobs::resume(Record record) {
  const Id id = record.request.id();
  Job& job = jobs_[id];
  job.request = std::move(record.request);
  job.received = record.received;
  // A wall clock that was set back must not lengthen the budget.
  const Duration elapsed = std::chrono::nanoseconds(std::max<Stamp>(0, ports_.clock.stamp() - record.received));
  job.arrived = ports_.clock.now() - elapsed;
  job.started = job.arrived;
  job.deadline = job.arrived + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(job.request.budget()));
  job.turn = turns_++;
  job.accepted = true;
  job.steps = job.committed = record.steps;
  job.ran = record.steps > 0;

  if (!job.request.resume())
    return finish(job,
                  {msg::FAILED, msg::make_error(msg::SERVER_RESTARTED, "the server was restarted before the plan was finished")});
  if (job.deadline <= ports_.clock.now()) return finish(job, {msg::EXPIRED, budget_error(job)});
  const RobotStatus status = ports_.planners.status(job.request.robot());
  if (auto refusal = admit(job.request, options_.budget_max, status, ports_.scenes))
    return finish(job, {msg::FAILED, std::move(*refusal)});
  job.replay = ports_.journal.steps(id, 0, kAllSteps);
  if (job.request.server() == options_.server)
    hold(job);
  else
    run_again(job);
}

void Jobs::run_again(Job& job) {
  if (can_start(job.request)) return start(job);
  enqueue(job);
}

// P36. What was addressed to this server may have been moved to another while this one was away. Only its client knows.
void Jobs::hold(Job& job) {
  job.held = true;
  set_alarm(job, std::min(job.deadline, ports_.clock.now() + seconds(options_.word_wait)));
  tell(job, msg::QUEUED,
       msg::make_error(msg::SERVER_RESTARTED,
                       "the server was restarted before the plan was finished; whoever still wants it from this server sends the "
                       "request again"));
}

// The same request again may also be an old message that waited for a late reader. One that moved it would follow at once.
void Jobs::hear_word(Job& job, const msg::PlanRequest& again) {
  if (!job.held || job.word || again.client() != job.request.client() || again.server() != options_.server) return;
  job.word = true;
  set_alarm(job, std::min(job.deadline, ports_.clock.now() + seconds(options_.word_settles)));
}

void Jobs::end_hold(Job& job) {
  if (!job.word && ports_.others_serve && ports_.others_serve()) return set_alarm(job, job.deadline);
  job.held = false;
  if (auto ending = hindrance(job)) return finish(job, std::move(*ending));
  run_again(job);
}

}  // namespace foothold::server
