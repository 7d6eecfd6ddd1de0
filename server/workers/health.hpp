// When a robot's workers may be started: exponential back-off after crashes, quarantine after repeated ones, one worker on trial
// after the quarantine. A value of time only; no clock, no process.
#pragma once

#include <chrono>
#include <deque>

#include "config/config.hpp"

namespace foothold::server {

class Health {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Duration = std::chrono::steady_clock::duration;

  explicit Health(const WorkersConfig& config) : config_(config) {}

  // A worker died by itself, spoke nonsense, used up its memory or was not ready in time. True: the robot is quarantined by it.
  bool crashed(Time now);
  // A worker finished a plan: no more back-off; a trial is passed. Crashes within the window still count.
  void proved();
  void set_limits(const WorkersConfig& config) { config_ = config; }
  // A new plugin was asked for: everything is forgiven.
  void forgive();

  bool quarantined(Time now) const { return now < quarantine_end_; }
  // Between the quarantine's end and the first finished plan: one worker only.
  bool on_trial(Time now) const { return trial_ && !quarantined(now); }
  // Until the next start is allowed; zero: now.
  Duration wait(Time now) const;
  std::size_t recent_crashes() const { return crashes_.size(); }

 private:
  WorkersConfig config_;
  std::deque<Time> crashes_;
  unsigned in_a_row_ = 0;
  Time restart_{}, quarantine_end_{};
  bool trial_ = false;
};

}  // namespace foothold::server
