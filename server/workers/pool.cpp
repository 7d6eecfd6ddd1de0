// Keeping as many workers as there are slots.
#include "workers/pool.hpp"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <cstdio>
#include <system_error>

#include "foothold/msg/errors.hpp"

namespace foothold::server {
namespace {

Time now() { return std::chrono::steady_clock::now(); }

double in_seconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

Duration from_seconds(double seconds) { return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds)); }

}  // namespace

Pool::Pool(boost::asio::io_context& loop, PoolListener& listener, RobotConfig robot, const WorkersConfig& config,
           std::string program)
    : loop_(loop),
      listener_(listener),
      robot_(std::move(robot)),
      config_(config),
      program_(std::move(program)),
      health_(config),
      timer_(loop) {}

Pool::~Pool() {
  for (Member& member : members_) member.worker->abandon();
}

void Pool::say(log::Level level, const std::string& sentence) const {
  log::say(level, "robot " + robot_.name + ": " + sentence, {{"robot", robot_.name}});
}

void Pool::open() {
  loaded_ = file_stamps();
  fill();
}

frame::Load Pool::load_frame() const {
  frame::Load load;
  load.robot(robot_.name);
  load.plugin_path(robot_.plugin);
  load.memory_limit(robot_.memory_limit);
  for (const auto& [path, quantity] : robot_.model.quantities()) {
    frame::ModelEntry& entry = load.model().emplace_back();
    entry.path(path);
    entry.values(quantity.values);
    entry.unit(quantity.unit);
    entry.source(quantity.source);
  }
  for (const auto& [path, text] : robot_.model.texts()) {
    frame::ModelText& entry = load.texts().emplace_back();
    entry.path(path);
    entry.text(text);
  }
  return load;
}

std::size_t Pool::wanted() const {
  if (closed_ || withdrawn_ || refused_ || health_.quarantined(now())) return 0;
  return health_.on_trial(now()) ? 1 : robot_.slots;
}

std::size_t Pool::present() const {
  return static_cast<std::size_t>(std::ranges::count_if(members_, [this](const Member& member) {
    return member.generation == generation_ && !member.retiring && member.worker->phase() != Worker::Phase::kLeaving;
  }));
}

void Pool::fill() {
  timer_.cancel();
  const Duration wait = health_.wait(now());
  if (wait > Duration::zero() && !closed_ && !withdrawn_ && !refused_) {
    timer_.expires_after(wait);
    timer_.async_wait([this, alive = std::weak_ptr(alive_)](const auto& error) {
      if (!error && !alive.expired()) fill();
    });
    return;
  }
  while (present() < wanted() && start_one()) {
  }
}

bool Pool::start_one() {
  try {
    auto worker = std::make_shared<Worker>(loop_, *this, robot_.name, program_);
    members_.push_back({worker, generation_});
    if (owed_ > 0) --owed_, ++restarts_;
    worker->load(load_frame(), from_seconds(config_.start_limit));
    return true;
  } catch (const std::system_error& fault) {
    start_failed(msg::make_error(msg::WORKER_CRASHED, std::string("the worker process cannot be started: ") + fault.what()));
    return false;
  }
}

void Pool::start_failed(const msg::Error& error) {
  count_crash(error);
  settle();
  changed();
  // The wait that count_crash() set.
  boost::asio::post(loop_, [this, alive = std::weak_ptr(alive_)] {
    if (!alive.expired()) fill();
  });
}

Worker* Pool::idle() const {
  if (closed_ || health_.quarantined(now())) return nullptr;
  for (const Member& member : members_)
    if (!member.retiring && member.worker->phase() == Worker::Phase::kIdle) return member.worker.get();
  return nullptr;
}

RobotStatus Pool::status() const {
  if (withdrawn_) return {described(msg::UNAVAILABLE, "the configuration does not hold it any more")};
  const bool any_ready = std::ranges::any_of(members_, &Member::ready);
  if (health_.quarantined(now()) || (health_.on_trial(now()) && !any_ready))
    // On trial the wait is over but its outcome is not known yet.
    return {described(msg::QUARANTINED, trouble_), std::max(in_seconds(health_.wait(now())), config_.restart_first)};
  if (refused_ && !any_ready) return {described(msg::UNAVAILABLE, refused_->message())};
  if (!info_) return {described(msg::UNAVAILABLE, trouble_.empty() ? "its planner is being loaded" : trouble_)};
  return {described(msg::READY, {})};
}

// Asked with every request and after every plan: copied only when something in it is new.
std::shared_ptr<const msg::RobotInfo> Pool::described(msg::RobotState state, const std::string& reason) const {
  if (described_ && described_->state() == state && described_->reason() == reason) return described_;
  msg::RobotInfo info;
  if (info_) info = *info_;
  info.name(robot_.name);
  if (!robot_.description.empty()) info.description(robot_.description);
  info.slots(withdrawn_ ? 0 : static_cast<std::uint32_t>(robot_.slots));
  info.state(state);
  info.reason(reason);
  described_ = std::make_shared<const msg::RobotInfo>(std::move(info));
  return described_;
}

void Pool::close() {
  closed_ = true;
  timer_.cancel();
  for (Member& member : members_) {
    if (member.worker->phase() == Worker::Phase::kBusy)
      member.worker->kill(msg::make_error(msg::WORKER_KILLED, "the server stops"), false);
    retire(member);
  }
}

void Pool::check_memory() {
  if (robot_.memory_limit == 0) return;
  for (const Member& member : members_) member.worker->check_memory(robot_.memory_limit);
}

std::vector<pid_t> Pool::pids() const {
  std::vector<pid_t> out;
  for (const Member& member : members_) out.push_back(member.worker->pid());
  return out;
}

PoolFigures Pool::figures() const {
  PoolFigures out{.restarts = restarts_, .crashes = crashes_, .workers = members_.size()};
  for (const Member& member : members_) {
    if (member.worker->phase() == Worker::Phase::kBusy) ++out.busy;
    out.memory += resident_memory(member.worker->pid()).value_or(0);
  }
  return out;
}

Pool::Member& Pool::member_of(const Worker& worker) {
  return *std::ranges::find_if(members_, [&](const Member& member) { return member.worker.get() == &worker; });
}

void Pool::retire(Member& member) {
  if (std::exchange(member.retiring, true) || member.worker->phase() == Worker::Phase::kBusy) return;
  if (member.worker->phase() != Worker::Phase::kLeaving) member.worker->retire();
}

void Pool::on_ready(Worker& worker, msg::RobotInfo info) {
  Member& member = member_of(worker);
  member.ready = true;
  say(log::Level::kInfo,
      "worker " + std::to_string(worker.pid()) + " is ready with " + info.plugin() + " " + info.plugin_version());
  info_ = std::move(info);
  described_.reset();
  trouble_.clear();
  // One for one, so that a reload never leaves fewer slots than there were; the rest when all newer ones are there.
  const auto newer = std::ranges::count_if(
      members_, [this](const Member& other) { return other.generation == generation_ && other.ready && !other.retiring; });
  retire_older(static_cast<std::size_t>(newer) >= wanted() ? members_.size() : 1);
  settle();
  changed();
}

void Pool::on_refused(Worker&, msg::Error reason) {
  say(log::Level::kError, reason.message());
  if (older_serve()) return give_up_reload(reason);
  refused_ = std::move(reason);
  settle();
  changed();
}

void Pool::on_report(Worker& worker, Run run, frame::Report report) {
  if (!report.leave()) health_.proved();
  Member& member = member_of(worker);
  if (member.retiring && worker.phase() == Worker::Phase::kIdle) worker.retire();
  RunEnd end{.state = report.state(), .error = std::move(report.reason()), .summary = std::move(report.summary())};
  // Memory that ran out ends the worker, in its own words or without.
  if (end.error.code() == msg::OUT_OF_MEMORY) end.kind = RunEnd::Kind::kLost;
  fill();
  listener_.on_run_end(run, std::move(end));
  changed();
}

void Pool::on_departure(Worker& worker, Departure departure) {
  const bool was_ready = member_of(worker).ready;
  const bool was_newest = member_of(worker).generation == generation_;
  std::erase_if(members_, [&](const Member& member) { return member.worker.get() == &worker; });
  if (departure.error.code() != msg::NO_ERROR) say(log::Level::kWarn, departure.error.message());
  if (departure.error.code() != msg::NO_ERROR && !closed_ && !withdrawn_ && was_newest) owed_ = std::min(owed_ + 1, robot_.slots);
  if (departure.crash) {
    ++crashes_;
    if (!was_ready && was_newest && older_serve())
      give_up_reload(departure.error);
    else
      count_crash(departure.error);
  }
  fill();
  if (!was_ready) settle();
  if (departure.run)
    listener_.on_run_end(*departure.run,
                         {.kind = RunEnd::Kind::kLost, .state = msg::CRASHED, .error = std::move(departure.error), .summary = {}});
  changed();
}

void Pool::count_crash(const msg::Error& error) {
  trouble_ = error.message();
  if (!health_.crashed(now())) return;
  trouble_ = std::to_string(health_.recent_crashes()) + " crashes, the last: " + error.message();
  char time[32];
  std::snprintf(time, sizeof time, "%g", config_.quarantine_time);
  say(log::Level::kError, std::string("quarantined for ") + time + " s: " + trouble_);
  for (Member& member : members_) retire(member);
}

void Pool::settle() {
  if (settled_) return;
  const bool loading = std::ranges::any_of(members_, [](const Member& member) {
    return !member.ready && !member.retiring && member.worker->phase() == Worker::Phase::kLoading;
  });
  if (loading) return;
  settled_ = true;
  boost::asio::post(loop_, [this, alive = std::weak_ptr(alive_)] {
    if (!alive.expired()) listener_.on_settled(robot_.name);
  });
}

// Told later and once, however much changes in one turn of the loop.
void Pool::changed() {
  if (std::exchange(telling_, true)) return;
  boost::asio::post(loop_, [this, alive = std::weak_ptr(alive_)] {
    if (alive.expired()) return;
    telling_ = false;
    listener_.on_slots_changed(robot_.name);
  });
}

}  // namespace foothold::server
