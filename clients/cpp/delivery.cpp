// Callbacks, one plan after the other.
#include "delivery.hpp"

namespace foothold::client {

void Delivery::post(std::shared_ptr<PlanState> plan) {
  {
    const std::lock_guard lock(mutex_);
    if (stop_) return;
    // A plan that waits in the queue tells all of its news when its turn comes.
    if (!plans_.empty() && plans_.back() == plan) return;
    plans_.push_back(std::move(plan));
    if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  }
  work_.notify_one();
}

void Delivery::stop() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  work_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void Delivery::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    work_.wait(lock, [this] { return stop_ || !plans_.empty(); });
    if (stop_) return;
    const auto plan = std::move(plans_.front());
    plans_.pop_front();
    lock.unlock();
    plan->deliver();
    lock.lock();
  }
}

}  // namespace foothold::client
