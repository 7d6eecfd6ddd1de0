// Workers: the planners of every robot, in processes that cannot take the server down. The one implementation of Planners.
//
//   Workers workers(loop, {.program = "/usr/lib/foothold/foothold-worker"}, robots);
//   workers.open(jobs, [] { /* every robot is ready or refused: announce */ });
//
// Thread rule: the loop's thread, which must be the one that outlives the workers: they die with it. RunEvents is called from the
// loop, never from inside one of these functions.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "workers/pool.hpp"

namespace foothold::server {

struct WorkersOptions {
  std::string program;  // foothold-worker
  WorkersConfig limits;
};

class Workers final : public Planners, private PoolListener {
 public:
  // Robots that are not enabled are left out. Nothing is started.
  Workers(boost::asio::io_context& loop, WorkersOptions options, std::vector<RobotConfig> robots);
  ~Workers() override;

  // Starts the workers of all robots at once. `settled`: every robot is ready, or it is known why it is not. Once.
  void open(RunEvents& events, std::function<void()> settled);

  // The names of all robots, in order.
  std::vector<std::string> robots() const;
  // Loads a robot's plugin again from its file, in new workers. Runs go on; if the newer plugin is refused the older stays.
  // False if there is no such robot.
  bool reload(const std::string& robot);
  // The robots and limits of a newer configuration: robots that are new come, those that are gone or not enabled any more leave
  // when their runs are over, those that changed get newer workers (Pool::apply). `settled`: every robot is ready again, or it is
  // known why it is not; called from the loop. A sentence for each robot that something happens to.
  std::vector<std::string> apply(WorkersOptions options, std::vector<RobotConfig> robots, std::function<void()> settled);
  // For the end of the server: idle workers leave, and are killed if they have not after a second; what still runs is killed at
  // once. None is started. `gone`: all have left.
  void close(std::function<void()> gone);

  RobotStatus status(const std::string& robot) const override;
  bool has_idle(const std::string& robot) const override;
  Run start(const msg::PlanRequest& request, double budget_left, const std::optional<StoredScene>& scene) override;
  void stop(Run run) override;
  void kill(Run run, const std::string& why) override;

  // The processes of a robot, for `foothold doctor` and tests.
  std::vector<pid_t> pids(const std::string& robot) const;
  PoolFigures figures(const std::string& robot) const;

 private:
  void on_run_scene(Run run, std::vector<msg::Shape> shapes) override { events_->on_run_scene(run, std::move(shapes)); }
  void on_run_step(Run run, std::uint32_t index, Bytes step) override { events_->on_run_step(run, index, std::move(step)); }
  void on_run_end(Run run, RunEnd end) override;
  void on_slots_changed(const std::string& robot) override;
  void on_settled(const std::string& robot) override;
  void watch_memory();
  void tell_gone();
  void add(RobotConfig robot, const WorkersOptions& options);

  boost::asio::io_context& loop_;
  boost::asio::steady_timer memory_timer_;
  std::map<std::string, std::unique_ptr<Pool>, std::less<>> pools_;
  std::unordered_map<Run, std::weak_ptr<Worker>> runs_;
  Run last_run_ = 0;
  RunEvents* events_ = nullptr;
  std::function<void()> settled_, gone_;
  bool closing_ = false;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace foothold::server
