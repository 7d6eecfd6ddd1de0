// How requests end: by themselves, by their budget, by a cancel, by the server's stop.
#include <cstdio>

#include "foothold/msg/errors.hpp"
#include "jobs/jobs.hpp"

namespace foothold::server {

// Enters the final state. Nothing about the request changes after this, and it is forgotten here when the commit has succeeded.
void Jobs::finish(Job& job, Ending ending) {
  const Id id = job.request.id();
  if (job.last.state() == msg::QUEUED) queue_.remove(job.place());
  set_alarm(job, std::nullopt);
  job.over = ports_.clock.now();
  msg::Summary summary = std::move(job.last.summary());
  job.last = change_event(speaker_, job.request, ending.state, ports_.clock.stamp(), job.steps, std::move(ending.error));
  if (job.ran) {
    complete_summary(summary, speaker_, job, ports_.planners.status(job.request.robot()));
    job.last.summary(std::move(summary));
  }
  write(job, [&] { ports_.journal.set_final(id, job.last); });
  push(id, job.last);
}

// Decides the final state of a running request, which it enters when its worker has heeded the stop token or died.
void Jobs::halt(Job& job, Ending ending) {
  job.ending = std::move(ending);
  ports_.planners.stop(*job.run);
  set_alarm(job, ports_.clock.now() + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(options_.grace)));
}

void Jobs::expire(Job& job) {
  Ending ending{msg::EXPIRED, budget_error(job)};
  if (job.run)
    halt(job, std::move(ending));
  else
    finish(job, std::move(ending));
}

msg::Error Jobs::budget_error(const Job& job) const {
  char text[96];
  std::snprintf(text, sizeof text, "the budget of %.6g s ended %s", job.request.budget(),
                job.run ? "while the plan was being made" : "while the request waited for a worker");
  return msg::make_error(msg::BUDGET_EXHAUSTED, text, "budget");
}

void Jobs::set_alarm(Job& job, std::optional<Time> at) {
  if (job.alarm) alarms_.erase({*job.alarm, job.request.id()});
  job.alarm = at;
  if (at) alarms_.emplace(*at, job.request.id());
}

void Jobs::tick() {
  const Time now = ports_.clock.now();
  while (!alarms_.empty() && alarms_.begin()->first <= now) {
    Job& job = jobs_.at(alarms_.begin()->second);
    if (job.ending) {
      set_alarm(job, std::nullopt);
      ports_.planners.kill(*job.run, "it did not heed its stop token within the grace time");
    } else if (job.held && job.deadline > now) {
      end_hold(job);
    } else {
      expire(job);
    }
  }
  for (auto entry = abandoned_.begin(); entry != abandoned_.end();) {
    if (entry->second > now) {
      ++entry;
      continue;
    }
    ports_.planners.kill(entry->first, "it did not heed its stop token within the grace time");
    entry = abandoned_.erase(entry);
  }
  early_cancels_.forget_old(now);
}

std::optional<Time> Jobs::next_deadline() const {
  std::optional<Time> next;
  const auto earlier = [&](Time at) {
    if (!next || at < *next) next = at;
  };
  if (!alarms_.empty()) earlier(alarms_.begin()->first);
  for (const auto& [run, at] : abandoned_) earlier(at);
  if (const auto at = early_cancels_.next()) earlier(*at);
  if (!unsaved_.empty()) earlier(save_again_);
  earlier(forget_again_);
  return next;
}

void Jobs::stop() {
  stopping_ = true;
  const Ending ending{msg::CANCELLED, msg::make_error(msg::SERVER_STOPPING, "the server is being stopped")};
  for (auto& [id, job] : jobs_) {
    if (job.ended() || job.ending) continue;
    if (job.run)
      halt(job, ending);
    else
      finish(job, ending);
  }
}

bool Jobs::busy_for(const Id& client) const {
  for (const auto& [id, job] : jobs_)
    if (job.request.client() == client) return true;
  return false;
}

}  // namespace foothold::server
