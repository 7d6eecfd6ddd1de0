// Private: the one thread on which callbacks run.
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>

#include "plan_state.hpp"

namespace foothold::client {

// Any thread may post. The thread starts with the first post.
class Delivery {
 public:
  Delivery() = default;
  ~Delivery() { stop(); }
  // Tells this plan's news soon.
  void post(std::shared_ptr<PlanState> plan);
  // Waits for the callback that runs now; nothing is told afterwards.
  void stop();

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable work_;
  std::deque<std::shared_ptr<PlanState>> plans_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace foothold::client
