// Hears STOP while plan() runs. plan() has the main thread to itself, because a hand-over to another thread would cost more than
// a short plan; this thread of its own looks at the channel, and only when a run lasts longer than a millisecond.
//
// Thread rule: begin() and end() by the main thread. Between them the channel is read by the watch alone.
#pragma once

#include <mutex>
#include <stop_token>
#include <thread>

#include "worker/channel.hpp"

namespace foothold::server {

class StopWatch {
 public:
  explicit StopWatch(Channel& channel);  // throws std::system_error
  ~StopWatch();

  // From now on STOP of `run`, or the daemon's end, sets `source`.
  void begin(std::uint64_t run, std::stop_source source);
  // After it the channel is the main thread's again.
  void end();

 private:
  void watch();
  void watch_one_run();
  bool look();  // true: the daemon is gone

  Channel& channel_;
  int timer_ = -1;  // rings when a run has lasted long enough to be watched
  int wake_ = -1;   // rings when a watched run ends
  std::mutex mutex_;
  bool running_ = false, watching_ = false, leaving_ = false;
  std::uint64_t run_ = 0;
  std::stop_source source_{std::nostopstate};
  std::thread thread_;
};

}  // namespace foothold::server
