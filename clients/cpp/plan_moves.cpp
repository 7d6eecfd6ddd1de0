// The rules of a plan with more than one server: when it goes to another, and which end counts. P37 to P39.
#include <algorithm>
#include <utility>

#include "foothold/msg/errors.hpp"
#include "plan_state.hpp"

namespace foothold::client {
namespace {

// Ends that say nothing about the request itself: another server may well plan it.
bool another_may(const msg::PlanEvent& event) {
  switch (event.error().code()) {
    case msg::SERVER_RESTARTED:
    case msg::SERVER_STOPPING:
      return event.state() == msg::FAILED || event.state() == msg::CANCELLED || event.state() == msg::REJECTED;
    case msg::QUEUE_FULL:
    case msg::ROBOT_UNAVAILABLE:
    case msg::ROBOT_QUARANTINED:
    case msg::STORAGE_FAILED:
    case msg::UNKNOWN_ROBOT:
    case msg::UNKNOWN_SCENE:
    case msg::UNKNOWN_REVISION:
      return event.state() == msg::REJECTED;
    default:
      return false;
  }
}

// Ends after which the request may have gone on elsewhere.
bool may_have_moved(const msg::PlanEvent& event) {
  return event.error().code() == msg::MOVED || event.error().code() == msg::SERVER_RESTARTED ||
         event.error().code() == msg::SERVER_STOPPING;
}

}  // namespace

bool PlanState::is_of_another(const msg::Id& server) const {
  return (server_ != msg::kNoId && server != server_) || std::ranges::find(left_, server) != left_.end();
}

bool PlanState::may_move() const { return origin_ == Origin::kSubmitted && !fixed_; }

// The end, unless somebody else may give another one.
void PlanState::accept_final(const msg::PlanEvent& event, std::span<const msg::Id> alive, Time now) {
  if (may_move() && !cancel_ && another_may(event)) {
    refusal_ = event;
    return;
  }
  const bool alone = std::ranges::all_of(
      alive, [&](const msg::Id& id) { return id == event.server() || std::ranges::find(left_, id) != left_.end(); });
  if (origin_ == Origin::kAskedFor && may_have_moved(event) && !alone) {
    moved_away_ = event;
    left_.push_back(event.server());
    server_ = msg::kNoId;
    state_ = msg::UNKNOWN;
    heard_ = false;
    announced_ = 0;
    steps_.begin_again();
    next_due_ = now;
    return;
  }
  end_as(event);
}

void PlanState::end_as(msg::PlanEvent event) {
  const bool whole = event.state() == msg::SUCCEEDED || event.state() == msg::PARTIAL;
  if (!left_.empty() && event.steps() < steps_.held()) {
    if (whole) return end_as_different(event.steps());
    // What came from the server before is as good as ever.
    event.steps(steps_.held());
    cut_ = true;
  }
  state_ = event.state();
  final_ = last_ = std::move(event);
}

void PlanState::end_as_different(std::uint32_t index) {
  msg::PlanEvent event;
  event.request(request_.id());
  event.client(request_.client());
  event.server(server_);
  event.robot(request_.robot());
  event.unit(request_.unit());
  event.state(msg::FAILED);
  event.stamp(std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count());
  event.steps(steps_.held());
  event.error(msg::make_error(msg::PLAN_DIFFERS, "server " + msg::to_hex(server_) + " took over and plans otherwise: step " +
                                                     std::to_string(index) + " is not the one of server " +
                                                     msg::to_hex(left_.empty() ? server_ : left_.back())));
  cut_ = true;
  state_ = event.state();
  final_ = last_ = event;
  farewell_.emplace();
  farewell_->id(request_.id());
  farewell_->client(request_.client());
  farewell_->reason("plans otherwise than the server before it");
}

std::optional<msg::CancelRequest> PlanState::take_farewell() {
  const std::lock_guard lock(mutex_);
  return std::exchange(farewell_, std::nullopt);
}

bool PlanState::wants_another() const {
  const std::lock_guard lock(mutex_);
  return !has_ended() && may_move() && (refusal_ || lost_);
}

std::vector<msg::Id> PlanState::left() const {
  const std::lock_guard lock(mutex_);
  return left_;
}

bool PlanState::move(const msg::Id& server, Time now) {
  {
    const std::lock_guard lock(mutex_);
    if (has_ended() || !may_move() || !(refusal_ || lost_)) return false;
    // Another thread has moved it since this server was chosen.
    if (server == server_ || std::ranges::find(left_, server) != left_.end()) return false;
    left_.push_back(server_);
    server_ = server;
    request_.server(server);
    if (request_.scene_revision().empty()) request_.scene_revision(revision_);
    if (std::exchange(lost_, false)) untold_.push_back({std::nullopt, false});
    refusal_.reset();
    final_.reset();  // of steps that never came
    state_ = msg::UNKNOWN;
    sent_ = heard_ = word_ = asked_ = false;
    announced_ = 0;
    not_known_ = 0;
    not_known_to_.clear();
    steps_.begin_again();
    next_due_ = now;
    patience_ = resend_after_;
    ++traffic_.moves;
  }
  return callbacks_.any();
}

bool PlanState::stay(Time now) {
  bool over = false;
  {
    const std::lock_guard lock(mutex_);
    if (!refusal_) return false;
    end_as(*std::exchange(refusal_, std::nullopt));
    over = note_end(now);
  }
  if (over) tell_over();
  return callbacks_.any();
}

}  // namespace foothold::client
