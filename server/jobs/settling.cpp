// The end of a batch: commit, then tell; and what happens when the journal cannot store.
#include <algorithm>
#include <unordered_set>

#include "foothold/msg/errors.hpp"
#include "jobs/admission/admission.hpp"
#include "jobs/jobs.hpp"

namespace foothold::server {
namespace {

constexpr std::size_t kMostUnsaved = 10000;
constexpr auto kSaveAgain = std::chrono::seconds(1);
constexpr auto kForgetAgain = std::chrono::minutes(1);
constexpr auto kForgetMore = std::chrono::milliseconds(50);

}  // namespace

Jobs::Jobs(JobsOptions options, Ports ports, Complain complain)
    : options_(std::move(options)),
      ports_(ports),
      complain_(complain ? std::move(complain) : [](const std::string&) {}),
      speaker_{options_.server, options_.version},
      forget_again_(ports.clock.now() + kForgetAgain) {}

void Jobs::set_options(JobsOptions options) {
  options.server = options_.server;
  options.version = options_.version;
  options_ = std::move(options);
  set_limits(options_.limits);
}

void Jobs::push(const Id& request, msg::PlanEvent event) {
  urgent_ = true;
  outgoing_.emplace_back(Told{request, std::make_unique<msg::PlanEvent>(std::move(event))});
}

void Jobs::tell(Job& job, msg::State state, msg::Error error) {
  job.last = change_event(speaker_, job.request, state, ports_.clock.stamp(), job.steps, std::move(error));
  push(job.request.id(), job.last);
}

void Jobs::settle() {
  const bool worked = storage_works_;
  if (look_again_) dispatch_all();
  settle_batch();
  save_unsaved();
  if (!worked && storage_works_) {  // what was held back goes on
    complain_("the journal can be written again");
    for (const auto& robot : queue_.robots()) on_slots_changed(robot);
    settle_batch();
  }
  forget_old();
}

void Jobs::settle_batch() {
  if (commit()) {
    for (const Id& id : touched_) {
      Job& job = jobs_.at(id);
      job.touched = false;
      job.accepted = true;
      job.committed = job.steps;
    }
  } else {
    const auto untold = [&](const Outgoing& out) {
      const auto* told = std::get_if<Told>(&out);
      const auto* sent = std::get_if<Sent>(&out);
      if (told == nullptr && sent == nullptr) return false;
      const auto job = jobs_.find(told != nullptr ? told->request : sent->request);
      return job != jobs_.end() && job->second.touched;
    };
    std::erase_if(outgoing_, untold);
    for (const Id& id : touched_) give_up(jobs_.at(id));
  }
  flush();
  for (const Id& id : touched_) {
    const auto job = jobs_.find(id);
    if (!job->second.ended()) continue;
    show_end(job->second);
    jobs_.erase(job);
  }
  touched_.clear();
  fault_.reset();
}

void Jobs::show_end(const Job& job) const {
  const auto seconds = [](Time from, Time to) { return std::chrono::duration<double>(to - from).count(); };
  const bool ran = job.stepped != Time{};
  EndedRequest ended{.request = job.request, .event = job.last, .ran = ran, .killed = job.killed};
  if (job.arrived != Time{}) ended.waited = seconds(job.arrived, ran ? job.started : job.over);
  if (ran) ended.planned = seconds(job.started, job.over);
  for (RequestWatch* watch : ports_.watches) watch->on_ended(ended);
}

// False if what the batch wrote is not stored.
bool Jobs::commit() {
  if (touched_.empty()) return true;
  if (!fault_) {
    try {
      ports_.journal.commit();
    } catch (const JournalError& error) {
      fault_ = error.what();
    }
  }
  if (fault_ && storage_works_) complain_(*fault_);
  storage_works_ = !fault_;
  return storage_works_;
}

// Ends a request whose part of the batch could not be stored. Its end is kept in memory until the journal takes it.
void Jobs::give_up(Job& job) {
  abandon(job);
  if (job.last.state() == msg::QUEUED) queue_.remove(job.place());
  set_alarm(job, std::nullopt);
  job.steps = job.committed;
  job.touched = false;
  job.over = ports_.clock.now();
  const bool refused = !job.accepted && job.last.state() == msg::REJECTED;
  if (!refused) {
    msg::Summary summary = std::move(job.last.summary());
    job.last = change_event(speaker_, job.request, job.accepted ? msg::FAILED : msg::REJECTED, ports_.clock.stamp(), job.steps,
                            msg::make_error(msg::STORAGE_FAILED, "the journal could not be written: " + *fault_));
    if (job.accepted && job.ran) {
      complete_summary(summary, speaker_, job, ports_.planners.status(job.request.robot()));
      job.last.summary(std::move(summary));
    }
  }
  if (unsaved_.empty()) save_again_ = ports_.clock.now() + kSaveAgain;
  if (unsaved_.size() >= kMostUnsaved) {
    complain_("too many ends of requests wait for the journal; one is forgotten: " + msg::to_hex(unsaved_.begin()->first));
    unsaved_.erase(unsaved_.begin());
  }
  unsaved_.insert_or_assign(job.request.id(), Unsaved{essence(job.request), job.received, job.last, job.accepted});
  push(job.request.id(), job.last);
}

// Steps go first: they are what a client waits for, and the order between the two topics is free. Answers go last: they give the
// state as it is now, which a client must not hear before the change that led to it.
void Jobs::flush() {
  std::unordered_set<Id, msg::IdHash> over;  // what has ended by now need not be said to run (P8)
  for (const Outgoing& out : outgoing_) {
    if (const auto* sent = std::get_if<Sent>(&out)) ports_.outbox.step(sent->client, sent->step);
    if (const auto* told = std::get_if<Told>(&out); told != nullptr && msg::is_final(told->event->state()))
      over.insert(told->request);
  }
  const auto outdated = [&](const Told& told) {
    return told.event->state() == msg::RUNNING && told.event->scene().empty() && over.contains(told.request);
  };
  for (const Outgoing& out : outgoing_)
    if (const auto* told = std::get_if<Told>(&out); told != nullptr && !outdated(*told))
      ports_.outbox.event(told->event->client(), *told->event);
  for (const Outgoing& out : outgoing_)
    if (const auto* asked = std::get_if<Asked>(&out)) answer(*asked);
  outgoing_.clear();
  urgent_ = false;
  repeat();
}

void Jobs::repeat() {
  try {
    repeats_.send(ports_.journal, ports_.outbox);
  } catch (const JournalError& error) {
    complain_(std::string("steps that were asked for cannot be read: ") + error.what());
  }
}

void Jobs::answer(const Asked& asked) {
  const auto say_unknown = [&](std::uint16_t code, const std::string& why) {
    const auto error = msg::make_error(code, why, "id");
    ports_.outbox.event(asked.client, unknown_event(speaker_, asked.request, asked.client, ports_.clock.stamp(), error));
  };
  try {
    if (const auto job = jobs_.find(asked.request); job != jobs_.end()) {
      msg::PlanEvent event = job->second.last;
      event.steps(job->second.steps);
      return answer_with(asked, std::move(event));
    }
    if (const auto unsaved = unsaved_.find(asked.request); unsaved != unsaved_.end())
      return answer_with(asked, unsaved->second.event);
    auto record = asked.request == msg::kNoId ? std::nullopt : ports_.journal.find(asked.request);
    if (!record) return say_unknown(msg::UNKNOWN_REQUEST, "no request " + msg::to_hex(asked.request) + " is known");
    if (!record->final_event)  // its end was among those that the storage could never take
      record->final_event = change_event(speaker_, record->request, msg::FAILED, ports_.clock.stamp(), record->steps,
                                         msg::make_error(msg::STORAGE_FAILED, "the end of this request could not be stored"));
    answer_with(asked, std::move(*record->final_event));
  } catch (const JournalError& error) {
    say_unknown(msg::STORAGE_FAILED, std::string("the journal could not be read: ") + error.what());
  }
}

// The event; the steps from `asked.from_step` on follow, unless they are under way. From 0 on with the scene's shapes, if it asked
// for them at all.
void Jobs::answer_with(const Asked& asked, msg::PlanEvent event) {
  event.answer(true);
  const std::uint32_t steps = event.steps();
  const bool wants_steps = asked.from_step && *asked.from_step < steps;
  const bool under_way = wants_steps && !repeats_.ask(asked.request, asked.client, *asked.from_step, steps, ports_.outbox);
  const bool stored = !unsaved_.contains(asked.request) || unsaved_.at(asked.request).accepted;
  if (asked.from_step == 0U && stored && !under_way)
    if (auto record = ports_.journal.find(asked.request)) event.scene(std::move(record->scene));
  ports_.outbox.event(asked.client, event);
}

// Tries again, apart from any batch, to store the ends that could not be stored.
void Jobs::save_unsaved() {
  const Time now = ports_.clock.now();
  if (unsaved_.empty() || now < save_again_) return;
  save_again_ = now + kSaveAgain;
  constexpr std::size_t kAtOnce = 500;
  std::vector<Id> saved;
  try {
    for (const auto& [id, end] : unsaved_) {
      if (saved.size() == kAtOnce) break;
      if (!end.accepted) ports_.journal.add_request(end.request, end.received);
      ports_.journal.set_final(id, end.event);
      saved.push_back(id);
    }
    ports_.journal.commit();
  } catch (const JournalError&) {
    return;
  }
  storage_works_ = true;
  for (const Id& id : saved) unsaved_.erase(id);
  if (!unsaved_.empty()) save_again_ = now;
}

void Jobs::forget_old() {
  const Time now = ports_.clock.now();
  if (now < forget_again_) return;
  forget_again_ = now + kForgetAgain;
  const auto kept = static_cast<Stamp>(options_.retention * 1e9);
  try {
    if (ports_.journal.forget_before(ports_.clock.stamp() - kept)) forget_again_ = now + kForgetMore;
    ports_.journal.commit();
  } catch (const JournalError& error) {
    complain_(std::string("old requests could not be forgotten: ") + error.what());
  }
}

}  // namespace foothold::server
