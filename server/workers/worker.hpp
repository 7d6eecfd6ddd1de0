// One worker process as the daemon sees it: frames in and out, each judged, and its death reported once.
//
// Thread rule: the loop's thread only. Owner's functions are called from the loop, never from inside a function of Worker.
#pragma once

#include <utility>  // before Asio, whose 1.74 forgets it under C++20

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <memory>
#include <optional>
#include <string>

#include "frames/frames.hpp"
#include "jobs/ports.hpp"
#include "workers/last_words.hpp"
#include "workers/process.hpp"

namespace foothold::server {

class Worker;

// How a worker left.
struct Departure {
  std::optional<Run> run;  // the run that it took with it
  msg::Error error;        // why; code 0: it left as it was meant to
  bool crash = false;      // counts towards quarantine
};

class WorkerOwner {
 public:
  virtual ~WorkerOwner() = default;
  virtual void on_ready(Worker& worker, msg::RobotInfo info) = 0;
  virtual void on_refused(Worker& worker, msg::Error reason) = 0;
  virtual void on_scene(Run run, std::vector<msg::Shape> shapes) = 0;
  virtual void on_step(Run run, std::uint32_t index, Bytes step) = 0;
  // The worker is idle again, unless the report says that it leaves.
  virtual void on_report(Worker& worker, Run run, frame::Report report) = 0;
  // The last call; the process is reaped.
  virtual void on_departure(Worker& worker, Departure departure) = 0;
};

class Worker : public std::enable_shared_from_this<Worker> {
 public:
  enum class Phase { kLoading, kIdle, kBusy, kLeaving };

  // Starts the process. Throws std::system_error. `name` is the robot, for the log. The owner outlives the worker's process.
  Worker(boost::asio::io_context& loop, WorkerOwner& owner, std::string name, const std::string& program);
  ~Worker() { abandon(); }

  // `limit`: to be ready within, or be killed.
  void load(const frame::Load& load, Duration limit);
  void plan(Run run, const frame::Plan& plan);  // precondition: idle
  void stop();                                  // the stop token of its run
  // SIGKILL to the process and what it started. The first cause given is the one reported.
  void kill(msg::Error cause, bool crash);
  // Lets an idle or loading worker end by itself; kills it if it does not within a second.
  void retire();
  // Kills and reaps it without a word to the owner: for the end of the daemon.
  void abandon();
  // Kills it if it holds more than `bytes`.
  void check_memory(std::uint64_t bytes);

  Phase phase() const { return phase_; }
  std::optional<Run> run() const { return run_; }
  pid_t pid() const { return process_.pid; }

 private:
  void watch_socket();
  void watch_words();
  void watch_exit();
  bool receive();  // false: nothing more is there
  void lose_channel();
  void let_leave();
  void take(const Frame& frame);
  void take_first(const Frame& frame);
  void take_of_run(const Frame& frame);
  void take_report(const Frame& frame);
  void send(Bytes frame);
  void flush();
  void hear();
  void depart();
  void close_all();
  Departure departure(const std::optional<ProcessEnd>& end) const;

  WorkerOwner& owner_;
  std::string name_;
  Process process_;
  boost::asio::posix::stream_descriptor socket_, words_, exit_;
  boost::asio::steady_timer timer_;
  LastWords last_words_;
  FrameReader in_;
  Bytes out_;  // what the socket did not take yet
  bool flushing_ = false, dying_ = false, departed_ = false;

  Phase phase_ = Phase::kLoading;
  std::optional<Run> run_;
  Id request_{};
  std::uint32_t next_step_ = 0;
  bool scene_seen_ = false;
  bool may_leave_ = false;           // its end is no surprise
  std::optional<msg::Error> cause_;  // why it was killed
  bool cause_is_crash_ = false;
};

}  // namespace foothold::server
