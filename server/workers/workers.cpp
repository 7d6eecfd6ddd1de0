// Robots to pools, runs to workers.
#include "workers/workers.hpp"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <set>
#include <stdexcept>

#include "foothold/msg/errors.hpp"

namespace foothold::server {
namespace {

constexpr auto kMemoryPeriod = std::chrono::milliseconds(100);

}  // namespace

Workers::Workers(boost::asio::io_context& loop, WorkersOptions options, std::vector<RobotConfig> robots)
    : loop_(loop), memory_timer_(loop) {
  for (RobotConfig& robot : robots)
    if (robot.enabled) add(std::move(robot), options);
}

void Workers::add(RobotConfig robot, const WorkersOptions& options) {
  PoolListener& listener = *this;
  std::string name = robot.name;
  pools_.emplace(std::move(name), std::make_unique<Pool>(loop_, listener, std::move(robot), options.limits, options.program));
}

Workers::~Workers() = default;

void Workers::open(RunEvents& events, std::function<void()> settled) {
  events_ = &events;
  settled_ = std::move(settled);
  for (auto& [name, pool] : pools_) pool->open();
  watch_memory();
  if (pools_.empty()) on_settled({});
}

std::vector<std::string> Workers::robots() const {
  std::vector<std::string> names;
  for (const auto& [name, pool] : pools_) names.push_back(name);
  return names;
}

bool Workers::reload(const std::string& robot) {
  const auto found = pools_.find(robot);
  if (found == pools_.end()) return false;
  found->second->reload();
  return true;
}

std::vector<std::string> Workers::apply(WorkersOptions options, std::vector<RobotConfig> robots, std::function<void()> settled) {
  std::vector<std::string> news;
  std::set<std::string> wanted;
  settled_ = std::move(settled);
  for (RobotConfig& robot : robots) {
    if (!robot.enabled) continue;
    const std::string name = robot.name;
    wanted.insert(name);
    if (const auto known = pools_.find(name); known != pools_.end()) {
      const bool anew = known->second->apply(std::move(robot), options.limits, options.program);
      news.push_back("robot " + name + (anew ? ": newer workers are started" : ": nothing changed, its workers stay"));
    } else {
      add(std::move(robot), options);
      pools_.at(name)->open();
      news.push_back("robot " + name + ": is new");
    }
  }
  for (auto& [name, pool] : pools_) {
    if (wanted.contains(name)) continue;
    pool->withdraw();
    news.push_back("robot " + name + ": leaves");
  }
  boost::asio::post(loop_, [this, alive = std::weak_ptr(alive_)] {
    if (!alive.expired()) on_settled({});
  });
  return news;
}

void Workers::close(std::function<void()> gone) {
  gone_ = std::move(gone);
  closing_ = true;
  memory_timer_.cancel();
  for (auto& [name, pool] : pools_) pool->close();
  boost::asio::post(loop_, [this, alive = std::weak_ptr(alive_)] {
    if (!alive.expired()) tell_gone();
  });
}

void Workers::tell_gone() {
  if (gone_ && std::ranges::all_of(pools_, [](const auto& entry) { return entry.second->empty(); }))
    std::exchange(gone_, nullptr)();
}

RobotStatus Workers::status(const std::string& robot) const {
  const auto found = pools_.find(robot);
  return found == pools_.end() ? RobotStatus{} : found->second->status();
}

bool Workers::has_idle(const std::string& robot) const {
  const auto found = pools_.find(robot);
  return found != pools_.end() && found->second->has_idle();
}

Run Workers::start(const msg::PlanRequest& request, double budget_left, const std::optional<StoredScene>& scene) {
  const auto found = pools_.find(request.robot());
  Worker* worker = found == pools_.end() ? nullptr : found->second->idle();
  if (worker == nullptr) throw std::logic_error("no idle worker of robot '" + request.robot() + "'");
  frame::Plan plan;
  plan.request(request);
  plan.budget_left(budget_left);
  if (scene) {
    plan.scene_revision(scene->revision);
    plan.scene_format(scene->format);
    plan.scene_path(scene->path);
  }
  const Run run = ++last_run_;
  runs_.emplace(run, worker->weak_from_this());
  worker->plan(run, plan);
  return run;
}

void Workers::stop(Run run) {
  const auto found = runs_.find(run);
  if (found == runs_.end()) return;
  if (const auto worker = found->second.lock()) worker->stop();
}

void Workers::kill(Run run, const std::string& why) {
  const auto found = runs_.find(run);
  if (found == runs_.end()) return;
  if (const auto worker = found->second.lock()) worker->kill(msg::make_error(msg::WORKER_KILLED, why), false);
}

std::vector<pid_t> Workers::pids(const std::string& robot) const {
  const auto found = pools_.find(robot);
  return found == pools_.end() ? std::vector<pid_t>{} : found->second->pids();
}

PoolFigures Workers::figures(const std::string& robot) const {
  const auto found = pools_.find(robot);
  return found == pools_.end() ? PoolFigures{} : found->second->figures();
}

void Workers::on_run_end(Run run, RunEnd end) {
  runs_.erase(run);
  events_->on_run_end(run, std::move(end));
}

void Workers::on_slots_changed(const std::string& robot) {
  events_->on_slots_changed(robot);
  tell_gone();
}

void Workers::on_settled(const std::string&) {
  if (settled_ && std::ranges::all_of(pools_, [](const auto& entry) { return entry.second->settled(); }))
    std::exchange(settled_, nullptr)();
}

void Workers::watch_memory() {
  memory_timer_.expires_after(kMemoryPeriod);
  memory_timer_.async_wait([this](const auto& error) {
    if (error || closing_) return;
    for (auto& [name, pool] : pools_) pool->check_memory();
    watch_memory();
  });
}

}  // namespace foothold::server
