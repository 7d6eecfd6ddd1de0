// From the log into the database.
#include "journal/carrier.hpp"

namespace foothold::server {
namespace {

constexpr auto kPace = std::chrono::milliseconds(20);  // gathers what comes in this time into one transaction
constexpr auto kTryAgain = std::chrono::seconds(1);

}  // namespace

Carrier::Carrier(std::unique_ptr<Store> store, const Log& log) : store_(std::move(store)), log_(log), thread_([this] { work(); }) {}

Carrier::~Carrier() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Carrier::push(BatchPointer batch) {
  const std::lock_guard lock(mutex_);
  queue_.push_back(std::move(batch));
  if (sleeping_) wake_.notify_one();
}

bool Carrier::wait_carried(std::uint64_t number) {
  std::unique_lock lock(mutex_);
  hurry_ = true;
  wake_.notify_one();
  progress_.wait(lock, [&] { return carried_ >= number || !trouble_.empty(); });
  return carried_ >= number;
}

void Carrier::forget_before(Stamp stamp) {
  const std::lock_guard lock(mutex_);
  forget_ = stamp;
  wake_.notify_one();
}

std::string Carrier::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

void Carrier::work() {
  std::vector<BatchPointer> batches;
  std::unique_lock lock(mutex_);
  for (;;) {
    // Under load it looks every kPace and nobody has to wake it; it sleeps when nothing came for that long.
    wake_.wait_for(lock, kPace, [&] { return stopping_ || hurry_; });
    if (batches.empty() && queue_.empty() && !forget_ && !stopping_ && !hurry_) {
      sleeping_ = true;
      wake_.wait(lock, [&] { return !queue_.empty() || forget_ || stopping_ || hurry_; });
      sleeping_ = false;
      continue;
    }
    hurry_ = false;
    batches.insert(batches.end(), queue_.begin(), queue_.end());
    queue_.clear();
    const bool last = stopping_;
    lock.unlock();
    const bool carried = carry(batches);
    if (carried) batches.clear();
    if (carried && !last) forget();
    lock.lock();
    progress_.notify_all();
    if (last && queue_.empty()) return;
    if (!carried) wake_.wait_for(lock, kTryAgain, [&] { return stopping_; });
  }
}

bool Carrier::carry(const std::vector<BatchPointer>& batches) {
  if (batches.empty()) return true;
  std::string trouble;
  try {
    store_->begin();
    for (const auto& batch : batches) visit_entries(batch->octets, [&](const Entry& entry) { store_->apply(entry); });
    store_->commit();
    carried_.store(batches.back()->number, std::memory_order_release);
    if (batches.front()->segment != batches.back()->segment) log_.remove_before(batches.back()->segment);
    store_->checkpoint();
  } catch (const sqlite::Error& error) {
    store_->roll_back();
    trouble = error.what();
  }
  const std::lock_guard lock(mutex_);
  trouble_ = trouble;
  return trouble.empty();
}

void Carrier::forget() {
  std::optional<Stamp> stamp;
  {
    const std::lock_guard lock(mutex_);
    stamp = forget_;
    forget_.reset();
  }
  if (!stamp) return;
  try {
    if (!store_->forget_before(*stamp)) return;
    const std::lock_guard lock(mutex_);
    if (!forget_) forget_ = stamp;  // there is more, after what waits
  } catch (const sqlite::Error&) {
    store_->roll_back();  // the next call tries again
  }
}

}  // namespace foothold::server
