// The arithmetic of back-off and quarantine.
#include "workers/health.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::server {
namespace {

Health::Duration seconds(double value) {
  return std::chrono::duration_cast<Health::Duration>(std::chrono::duration<double>(value));
}

}  // namespace

bool Health::crashed(Time now) {
  crashes_.push_back(now);
  while (now - crashes_.front() > seconds(config_.quarantine_window)) crashes_.pop_front();
  // Workers that die while the robot is out already change nothing.
  if (quarantined(now)) return false;
  if (trial_ || crashes_.size() >= config_.quarantine_crashes) {
    quarantine_end_ = now + seconds(config_.quarantine_time);
    trial_ = true;
    in_a_row_ = 0;
    restart_ = {};
    return true;
  }
  const double wait = config_.restart_first * std::exp2(std::min(in_a_row_, 60u));
  restart_ = now + seconds(std::min(wait, config_.restart_longest));
  ++in_a_row_;
  return false;
}

void Health::proved() {
  in_a_row_ = 0;
  if (trial_) forgive();
}

void Health::forgive() {
  crashes_.clear();
  in_a_row_ = 0;
  restart_ = quarantine_end_ = {};
  trial_ = false;
}

Health::Duration Health::wait(Time now) const { return std::max({restart_ - now, quarantine_end_ - now, Duration::zero()}); }

}  // namespace foothold::server
