// The rules of one plan on the client's side: P3, P14, P17, P18 and the silence of its server. More servers: plan_moves.cpp.
#include "plan_state.hpp"

#include <algorithm>
#include <utility>

#include "foothold/msg/errors.hpp"
#include "outgoing.hpp"

namespace foothold::client {
namespace {

constexpr double kMostPatienceToAsk = 10.0;  // times repair_after
constexpr double kMostPatienceToSend = 4.0;  // s
constexpr int kUnknownForGood = 4;           // answers in a row, where not every server answers

PlanState::Clock::duration from_seconds(double seconds) {
  return std::chrono::duration_cast<PlanState::Clock::duration>(std::chrono::duration<double>(seconds));
}

// Waits for `done`, for ever if `seconds` is not finite.
template <class Done>
bool wait_for(std::condition_variable& news, std::unique_lock<std::mutex>& lock, double seconds, Done done) {
  if (seconds < 1e9) return news.wait_for(lock, from_seconds(seconds), done);
  news.wait(lock, done);
  return true;
}

}  // namespace

PlanState::PlanState(msg::PlanRequest request, Origin origin, std::uint32_t from, PlanCallbacks callbacks,
                     const ClientOptions& options, std::weak_ptr<Outgoing> outgoing)
    : request_(std::move(request)),
      origin_(origin),
      callbacks_(std::move(callbacks)),
      repair_after_(options.repair_after),
      resend_after_(options.resend_after),
      fixed_(!options.failover || request_.server() != msg::kNoId),
      outgoing_(std::move(outgoing)),
      steps_(from),
      server_(request_.server()),
      patience_(origin == Origin::kSubmitted ? resend_after_ : repair_after_) {
  times_.submitted = Clock::now();
}

bool PlanState::accept(msg::Step step, Time now) {
  bool over = false;
  {
    const std::lock_guard lock(mutex_);
    if (has_ended() || is_of_another(step.server())) return false;
    if (server_ == msg::kNoId) server_ = step.server();
    switch (steps_.add(std::move(step))) {
      case StepOrder::Added::kTwice:
        ++traffic_.duplicates;
        return false;
      case StepOrder::Added::kEarly:
        next_due_ = std::min(next_due_, now + from_seconds(repair_after_));
        return false;
      case StepOrder::Added::kDiffers:
        end_as_different(steps_.next());
        break;
      case StepOrder::Added::kInOrder:
        break;
    }
    if (times_.first_step == Time{}) times_.first_step = now;
    progress(now);
    over = note_end(now);
  }
  arrived_.notify_all();
  if (over) over_.notify_all();
  return callbacks_.any();
}

bool PlanState::accept(const msg::PlanEvent& event, std::span<const msg::Id> alive, Time now) {
  bool over = false;
  {
    const std::lock_guard lock(mutex_);
    if (has_ended() || refusal_ || is_of_another(event.server())) return false;
    if (std::exchange(lost_, false)) untold_.push_back({std::nullopt, false});  // who answers is not lost
    if (event.answer()) asked_ = false;
    if (event.state() == msg::UNKNOWN) {
      accept_unknown(event, alive, now);
      if (!final_) return false;
    } else {
      server_ = event.server();
      last_ = event;
      not_known_ = 0;
      not_known_to_.clear();
      announced_ = std::max(announced_, event.steps());
      if (scene_.empty()) scene_ = event.scene();
      if (final_) return false;
      if (!std::exchange(heard_, true) || event.state() != state_) {
        progress(now);
        state_ = event.state();
        if (msg::is_final(state_))
          accept_final(event, alive, now);
        else
          untold_.push_back({event, false});
      } else if (misses_steps()) {
        next_due_ = std::min(next_due_, now + from_seconds(repair_after_));
      }
      if (event.state() == msg::QUEUED && event.error().code() == msg::SERVER_RESTARTED && origin_ == Origin::kSubmitted) {
        word_ = true;
        next_due_ = now;
      }
    }
    over = note_end(now);
  }
  // A change of state alone wakes nobody: who waits for a step would only fall asleep again.
  if (over) tell_over();
  return callbacks_.any();
}

// P18. A request of our own that its server does not know was lost on the way, unless the server had it before: then its journal is
// gone, which a repeated answer proves (the first may have overtaken the request).
void PlanState::accept_unknown(const msg::PlanEvent& event, std::span<const msg::Id> alive, Time now) {
  ++not_known_;
  not_known_to_.push_back(event.server());
  const bool unknown_to_all = !alive.empty() && std::ranges::all_of(alive, [&](const msg::Id& id) {
    return std::ranges::find(not_known_to_, id) != not_known_to_.end() || std::ranges::find(left_, id) != left_.end();
  });
  if (origin_ == Origin::kSubmitted && !heard_) {
    next_due_ = std::min(next_due_, now + from_seconds(repair_after_));
    return;
  }
  if (not_known_ < kUnknownForGood && (heard_ || !unknown_to_all)) return;
  if (moved_away_) return end_as(*std::exchange(moved_away_, std::nullopt));
  final_ = last_ = event;
  state_ = msg::UNKNOWN;
}

bool PlanState::set_server_lost(const msg::Id& server, bool lost, Time now) {
  {
    const std::lock_guard lock(mutex_);
    if (has_ended() || server != server_ || lost_ == lost) return false;
    lost_ = lost;
    untold_.push_back({std::nullopt, lost});
    next_due_ = now;
    patience_ = repair_after_;
  }
  return callbacks_.any();
}

void PlanState::progress(Time now) {
  heard_ = true;
  asked_ = false;
  patience_ = repair_after_;
  next_due_ = now + from_seconds(patience_);
}

bool PlanState::note_end(Time now) {
  if (has_ended() && times_.ended == Time{}) times_.ended = now;
  return has_ended();
}

void PlanState::tell_over() {
  arrived_.notify_all();
  over_.notify_all();
}

bool PlanState::has_ended() const {
  return final_ && (cut_ || final_->state() == msg::UNKNOWN || steps_.next() >= final_->steps());
}

bool PlanState::misses_steps() const { return steps_.gap() || announced_ > steps_.next(); }

PlanState::Due PlanState::due(Time now) {
  const std::lock_guard lock(mutex_);
  if (has_ended() || lost_ || refusal_ || now < next_due_) return Due::kNothing;
  next_due_ = now + from_seconds(patience_);
  if (std::exchange(word_, false)) {
    ++traffic_.requests;
    return Due::kSend;
  }
  if (origin_ == Origin::kSubmitted && !heard_) {
    if (sent_) patience_ = std::min(2.0 * patience_, kMostPatienceToSend);
    sent_ = true;
    ++traffic_.requests;
    return Due::kSend;
  }
  // What is known to be missing is asked for steadily, and so is the end of what was cancelled; where nothing may be missing, or
  // the question before is still without an answer, ever more rarely.
  const bool unanswered = std::exchange(asked_, true);
  const bool rarely = unanswered || (!misses_steps() && !cancel_);
  patience_ = rarely ? std::min(2.0 * patience_, kMostPatienceToAsk * repair_after_) : repair_after_;
  ++traffic_.queries;
  return Due::kAsk;
}

void PlanState::wait_for_news(Time now) {
  const std::lock_guard lock(mutex_);
  if (sent_ || heard_) next_due_ = std::max(next_due_, now + from_seconds(repair_after_));
}

bool PlanState::unsent() const {
  const std::lock_guard lock(mutex_);
  return origin_ == Origin::kSubmitted && !sent_;
}

void PlanState::choose(const msg::Id& server, const std::string& revision) {
  const std::lock_guard lock(mutex_);
  if (request_.server() != msg::kNoId) return;
  revision_ = revision;
  request_.server(server);
  server_ = server;
}

msg::StateQuery PlanState::question(const msg::Id& client) const {
  const std::lock_guard lock(mutex_);
  msg::StateQuery query;
  query.client(client);
  query.request(request_.id());
  query.from_step(steps_.next());
  return query;
}

std::optional<msg::CancelRequest> PlanState::unanswered_cancel() const {
  const std::lock_guard lock(mutex_);
  return has_ended() ? std::nullopt : cancel_;
}

void PlanState::deliver() {
  std::unique_lock lock(mutex_);
  while (!detached_) {
    if (!untold_.empty()) {
      const News news = std::move(untold_.front());
      untold_.pop_front();
      lock.unlock();
      if (news.event && callbacks_.on_event) callbacks_.on_event(*news.event);
      if (!news.event && callbacks_.on_server) callbacks_.on_server(news.lost);
    } else if (told_steps_ < steps_.ready().size()) {
      const msg::Step& step = steps_.ready()[told_steps_++];
      lock.unlock();
      if (callbacks_.on_step) callbacks_.on_step(step);
    } else if (has_ended() && !told_end_) {
      told_end_ = true;
      const msg::PlanEvent event = *final_;
      lock.unlock();
      if (callbacks_.on_event) callbacks_.on_event(event);
    } else {
      return;
    }
    lock.lock();
  }
}

void PlanState::detach() {
  {
    const std::lock_guard lock(mutex_);
    detached_ = true;
  }
  tell_over();
}

const msg::Step* PlanState::next(std::size_t& place, double seconds) {
  std::unique_lock lock(mutex_);
  wait_for(arrived_, lock, seconds, [&] { return place < steps_.ready().size() || has_ended() || detached_; });
  return place < steps_.ready().size() ? &steps_.ready()[place++] : nullptr;
}

std::optional<msg::PlanEvent> PlanState::wait(double seconds) const {
  std::unique_lock lock(mutex_);
  wait_for(over_, lock, seconds, [&] { return has_ended() || detached_; });
  return has_ended() ? final_ : std::nullopt;
}

msg::PlanRequest PlanState::request() const {
  const std::lock_guard lock(mutex_);
  return request_;
}

msg::Id PlanState::server() const {
  const std::lock_guard lock(mutex_);
  return server_;
}

msg::State PlanState::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

std::optional<msg::PlanEvent> PlanState::last_event() const {
  const std::lock_guard lock(mutex_);
  return last_;
}

bool PlanState::ended() const {
  const std::lock_guard lock(mutex_);
  return has_ended();
}

bool PlanState::over() const {
  const std::lock_guard lock(mutex_);
  return has_ended() && (told_end_ || !callbacks_.any());
}

bool PlanState::server_lost() const {
  const std::lock_guard lock(mutex_);
  return lost_;
}

std::size_t PlanState::steps_ready() const {
  const std::lock_guard lock(mutex_);
  return steps_.ready().size();
}

PlanTraffic PlanState::traffic() const {
  const std::lock_guard lock(mutex_);
  return traffic_;
}

PlanTimes PlanState::times() const {
  const std::lock_guard lock(mutex_);
  return times_;
}

PlanRecord PlanState::record() const {
  const std::lock_guard lock(mutex_);
  PlanRecord record{request_, final_.value_or(msg::PlanEvent()), scene_, {steps_.ready().begin(), steps_.ready().end()}};
  if (!final_) record.final_event.request(request_.id());
  return record;
}

void PlanState::cancel(const std::string& reason) {
  msg::CancelRequest cancel;
  {
    const std::lock_guard lock(mutex_);
    cancel.id(request_.id());
    cancel.client(request_.client());
    cancel.reason(reason);
    cancel_ = cancel;
    patience_ = repair_after_;
    next_due_ = std::min(next_due_, Clock::now() + from_seconds(repair_after_));
  }
  if (const auto outgoing = outgoing_.lock()) outgoing->send(cancel);
}

}  // namespace foothold::client
