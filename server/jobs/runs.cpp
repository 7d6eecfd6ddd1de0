// What happens between a request and its worker.
#include "foothold/msg/errors.hpp"
#include "jobs/admission/admission.hpp"
#include "jobs/jobs.hpp"

namespace foothold::server {

Job* Jobs::job_of(Run run) {
  const auto found = runs_.find(run);
  return found == runs_.end() ? nullptr : &jobs_.at(found->second);
}

// While the storage fails nothing starts before its receipt is committed: it would only be stopped again. What waits although a
// slot is idle waits for plans of its own client to end.
bool Jobs::can_start(const msg::PlanRequest& request) const {
  const std::size_t most = options_.limits.running_per_client;
  if (!storage_works_ || !ports_.planners.has_idle(request.robot())) return false;
  return (most == 0 || shares_.of(request.client()) < most) && !queue_.next(request.robot(), shares_, most);
}

void Jobs::enqueue(Job& job) {
  queue_.add(job.place(), job.request.id());
  set_alarm(job, job.deadline);
  tell(job, msg::QUEUED, {});
}

void Jobs::dispatch(const std::string& robot) {
  while (ports_.planners.has_idle(robot)) {
    const auto next = queue_.next(robot, shares_, options_.limits.running_per_client);
    if (!next) return;
    Job& job = jobs_.at(*next);
    if (auto ending = hindrance(job)) {
      finish(job, std::move(*ending));
      continue;
    }
    queue_.take(job.place());
    start(job);
  }
}

void Jobs::dispatch_all() {
  look_again_ = false;
  if (!storage_works_) return;
  for (const std::string& robot : queue_.robots()) dispatch(robot);
}

// Why a request that waited cannot start now.
std::optional<Ending> Jobs::hindrance(const Job& job) const {
  if (job.deadline <= ports_.clock.now()) return Ending{msg::EXPIRED, budget_error(job)};
  const std::string& name = job.request.scene();
  const std::string& revision = job.request.scene_revision();
  if (name.empty() || ports_.scenes.find(name, revision)) return std::nullopt;
  return Ending{msg::FAILED, msg::make_error(msg::UNKNOWN_REVISION,
                                             "scene_revision " + revision + " of scene '" + name + "' is gone", "scene_revision")};
}

void Jobs::start(Job& job) {
  job.started = job.stepped = ports_.clock.now();
  job.ran = true;
  std::optional<StoredScene> scene;
  if (!job.request.scene().empty()) scene = ports_.scenes.find(job.request.scene(), job.request.scene_revision());
  const double left = std::chrono::duration<double>(job.deadline - job.started).count();
  job.run = ports_.planners.start(job.request, left, scene);
  runs_.emplace(*job.run, job.request.id());
  shares_.began(job.request.client(), job.request.robot());
  set_alarm(job, job.deadline);
  job.last = change_event(speaker_, job.request, msg::RUNNING, ports_.clock.stamp(), job.steps, {});
  job.told = false;
  if (job.request.shapes()) return;
  const bool urgent = urgent_;
  tell_running(job);
  urgent_ = urgent;
}

// With shapes the event waits for the scene's, which come before the first step.
void Jobs::tell_running(Job& job) {
  if (job.told) return;
  job.told = true;
  msg::PlanEvent event = job.last;
  event.scene(std::move(job.scene));
  job.scene.clear();
  push(job.request.id(), std::move(event));
}

void Jobs::on_run_scene(Run run, std::vector<msg::Shape> shapes) {
  Job* job = job_of(run);
  if (job == nullptr || job->ending || job->told) return;
  job->scene = std::move(shapes);
  write(*job, [&] { ports_.journal.set_scene(job->request.id(), job->scene); });
  tell_running(*job);
}

void Jobs::on_run_step(Run run, std::uint32_t index, Bytes step) {
  Job* job = job_of(run);
  if (job == nullptr || job->ending) return;  // its final state is decided: no step after that
  urgent_ = true;
  tell_running(*job);
  if (index != job->seen) {
    abandon(*job);
    const std::string message = "step " + std::to_string(index) + " came where step " + std::to_string(job->seen) + " was due";
    return finish(*job, {msg::FAILED, msg::make_error(msg::WORKER_PROTOCOL, message)});
  }
  ++job->seen;
  sign_step(speaker_, step);
  if (index < job->replay.size()) return replayed(*job, index, std::move(step));
  const Id id = job->request.id();
  write(*job, [&] { ports_.journal.add_step(id, index, step); });
  ++job->steps;
  const Time now = ports_.clock.now();
  const auto seconds_since = [&](Time then) { return std::chrono::duration<double>(now - then).count(); };
  for (RequestWatch* watch : ports_.watches)
    watch->on_step(job->request, index, seconds_since(job->stepped), seconds_since(job->arrived));
  job->stepped = now;
  outgoing_.emplace_back(Sent{id, job->request.client(), std::move(step)});
}

void Jobs::replayed(Job& job, std::uint32_t index, Bytes step) {
  if (job.replay[index] == step) {
    outgoing_.emplace_back(Sent{job.request.id(), job.request.client(), std::move(step)});
    return;
  }
  abandon(job);
  const std::string message =
      "planned again after a restart, step " + std::to_string(index) + " differs from the one that was sent before";
  finish(job, {msg::FAILED, msg::make_error(msg::SERVER_RESTARTED, message)});
}

void Jobs::on_run_end(Run run, RunEnd end) {
  abandoned_.erase(run);
  Job* job = job_of(run);
  if (job == nullptr) return;
  run_is_over(*job);
  job->killed = end.kind == RunEnd::Kind::kLost && end.error.code() == msg::WORKER_KILLED;
  constexpr double kWeight = 0.1;
  mean_run_ += kWeight * (std::chrono::duration<double>(ports_.clock.now() - job->started).count() - mean_run_);
  tell_running(*job);
  Ending ending = job->ending ? *job->ending : ending_of(end);
  const bool by_itself = !job->ending && end.kind == RunEnd::Kind::kReport;
  if (by_itself && job->seen < job->replay.size()) {
    const std::string message = "planned again after a restart, the plan ended after " + std::to_string(job->seen) + " of the " +
                                std::to_string(job->replay.size()) + " steps that were sent before";
    ending = {msg::FAILED, msg::make_error(msg::SERVER_RESTARTED, message)};
  }
  job->last.summary(std::move(end.summary));
  finish(*job, std::move(ending));
}

void Jobs::run_is_over(Job& job) {
  runs_.erase(*job.run);
  job.run.reset();
  shares_.over(job.request.client(), job.request.robot());
  look_again_ = look_again_ || options_.limits.running_per_client != 0;
}

// Takes the run away from its request: what it still says is nobody's.
void Jobs::abandon(Job& job) {
  if (!job.run) return;
  ports_.planners.stop(*job.run);
  const auto grace = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(options_.grace));
  abandoned_.emplace(*job.run, ports_.clock.now() + grace);
  run_is_over(job);
}

void Jobs::on_slots_changed(const std::string& robot) {
  if (queue_.empty(robot)) return;
  const RobotStatus status = ports_.planners.status(robot);
  if (auto refusal = check_robot(robot, status)) {
    for (const Id& id : queue_.of(robot)) finish(jobs_.at(id), {msg::FAILED, *refusal});
    return;
  }
  if (storage_works_) dispatch(robot);
}

}  // namespace foothold::server
