// The workers of one robot: as many as it has slots, started again when they die, taken out when they die too often, replaced by
// newer ones on reload (pool_reload.cpp).
//
// Thread rule: the loop's thread only.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/config.hpp"
#include "log/log.hpp"
#include "workers/health.hpp"
#include "workers/worker.hpp"

namespace foothold::server {

// What a pool tells; called from the loop, never from inside a function of Pool.
class PoolListener : public RunEvents {
 public:
  // Every slot was tried once: the robot is ready, or it is known why it is not.
  virtual void on_settled(const std::string& robot) = 0;
};

// Counts since the start, and what is now. Memory in octets, resident.
struct PoolFigures {
  std::uint64_t restarts = 0;  // workers started in the place of ones that died or were killed
  std::uint64_t crashes = 0;   // that count towards quarantine
  std::size_t workers = 0, busy = 0;
  std::uint64_t memory = 0;
};

class Pool final : public WorkerOwner {
 public:
  Pool(boost::asio::io_context& loop, PoolListener& listener, RobotConfig robot, const WorkersConfig& config, std::string program);
  ~Pool() override;

  void open();
  RobotStatus status() const;
  bool has_idle() const { return idle() != nullptr; }
  Worker* idle() const;
  // Newer workers from the file on disk. The ones of before go on until the newer are ready, finish their runs, and stay if the
  // newer are refused.
  void reload();
  // The robot as a newer configuration has it. Reloads, and returns true, if its numbers, its planner's file or the worker program
  // are others than those that are loaded, or if it is not READY: whoever asks has mended something. Else its workers stay.
  bool apply(RobotConfig robot, const WorkersConfig& limits, std::string program);
  // The configuration does not hold the robot any more: runs go on to their end, nothing new is taken. apply() brings it back.
  void withdraw();
  // Nothing is started any more; idle workers leave, busy ones are killed.
  void close();
  bool empty() const { return members_.empty(); }
  void check_memory();
  bool settled() const { return settled_; }
  std::vector<pid_t> pids() const;
  PoolFigures figures() const;

 private:
  struct Member {
    std::shared_ptr<Worker> worker;
    unsigned generation;
    bool ready = false;
    bool retiring = false;  // leaves when its run is over
  };

  void on_ready(Worker& worker, msg::RobotInfo info) override;
  void on_refused(Worker& worker, msg::Error reason) override;
  void on_scene(Run run, std::vector<msg::Shape> shapes) override { listener_.on_run_scene(run, std::move(shapes)); }
  void on_step(Run run, std::uint32_t index, Bytes step) override { listener_.on_run_step(run, index, std::move(step)); }
  void on_report(Worker& worker, Run run, frame::Report report) override;
  void on_departure(Worker& worker, Departure departure) override;

  std::size_t wanted() const;
  std::size_t present() const;
  bool older_serve() const;
  void fill();
  bool start_one();
  void start_failed(const msg::Error& error);
  void retire(Member& member);
  void retire_older(std::size_t most);
  void give_up_reload(const msg::Error& reason);
  void count_crash(const msg::Error& error);
  void say(log::Level level, const std::string& sentence) const;
  void settle();
  void changed();
  std::shared_ptr<const msg::RobotInfo> described(msg::RobotState state, const std::string& reason) const;
  Member& member_of(const Worker& worker);
  frame::Load load_frame() const;
  std::string file_stamps() const;

  boost::asio::io_context& loop_;
  PoolListener& listener_;
  RobotConfig robot_;
  WorkersConfig config_;
  std::string program_;
  Health health_;
  boost::asio::steady_timer timer_;  // the next start that had to wait
  std::vector<Member> members_;
  unsigned generation_ = 0;
  bool closed_ = false, withdrawn_ = false, settled_ = false, telling_ = false;
  std::string loaded_;                                       // file_stamps() when the generation began
  std::optional<msg::RobotInfo> info_;                       // of the newest worker that was ready
  mutable std::shared_ptr<const msg::RobotInfo> described_;  // what status() said last
  std::optional<msg::Error> refused_;                        // why no worker is started
  std::string trouble_;                                      // what happened last, for people
  std::uint64_t restarts_ = 0, crashes_ = 0;
  std::size_t owed_ = 0;                                        // workers that died and have not been replaced yet
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  // for what was posted and outlives this
};

}  // namespace foothold::server
