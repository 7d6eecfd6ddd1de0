// Private: puts the steps of one plan in order. What arrives early waits, what arrives twice is dropped. When another server plans
// anew, its steps are compared octet for octet with those that are there already, and only then is its plan gone on with.
#pragma once

#include <foothold.h>

#include <cstdint>
#include <deque>
#include <map>

#include "foothold/msg/cdr.hpp"

namespace foothold::client {

class StepOrder {
 public:
  explicit StepOrder(std::uint32_t first) : first_(first), next_(first) {}

  enum class Added { kInOrder, kEarly, kTwice, kDiffers };
  // kDiffers: next() is the number of the first step that is not the same.
  Added add(msg::Step step) {
    const std::uint32_t index = step.index();
    if (index < next_) return Added::kTwice;
    if (index > next_) {
      // A server that numbers wildly must not fill our memory; what is left out here is asked for again.
      if (early_.size() >= kEarlyLimit) return Added::kTwice;
      return early_.emplace(index, std::move(step)).second ? Added::kEarly : Added::kTwice;
    }
    if (!take(std::move(step))) return Added::kDiffers;
    for (auto early = early_.begin(); early != early_.end() && early->first == next_; early = early_.erase(early))
      if (!take(std::move(early->second))) return Added::kDiffers;
    return Added::kInOrder;
  }
  // Another server begins with the first step.
  void begin_again() {
    next_ = first_;
    early_.clear();
  }

  // Steps in order; references to them stay valid.
  const std::deque<msg::Step>& ready() const { return ready_; }
  // The number of the first step that is not there, from the server that plans now.
  std::uint32_t next() const { return next_; }
  // How many the plan has so far, from whomever, those before the first included.
  std::uint32_t held() const { return first_ + static_cast<std::uint32_t>(ready_.size()); }
  bool gap() const { return !early_.empty(); }

 private:
  static constexpr std::size_t kEarlyLimit = 65536;

  bool take(msg::Step step) {
    if (next_ == held()) {
      ready_.push_back(std::move(step));
    } else {
      const msg::Step& there = ready_[next_ - first_];
      step.server(there.server());
      if (msg::encode(step) != msg::encode(there)) return false;
    }
    ++next_;
    return true;
  }

  std::uint32_t first_, next_;
  std::deque<msg::Step> ready_;
  std::map<std::uint32_t, msg::Step> early_;
};

}  // namespace foothold::client
