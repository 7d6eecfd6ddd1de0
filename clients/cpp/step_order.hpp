// Private: puts the steps of one plan in order. What arrives early waits, what arrives twice is dropped.
#pragma once

#include <foothold.h>

#include <cstdint>
#include <deque>
#include <map>

namespace foothold::client {

class StepOrder {
 public:
  explicit StepOrder(std::uint32_t first) : first_(first) {}

  enum class Added { kInOrder, kEarly, kTwice };
  Added add(msg::Step step) {
    const std::uint32_t index = step.index();
    if (index < next()) return Added::kTwice;
    if (index > next()) {
      // A server that numbers wildly must not fill our memory; what is left out here is asked for again.
      if (early_.size() >= kEarlyLimit) return Added::kTwice;
      return early_.emplace(index, std::move(step)).second ? Added::kEarly : Added::kTwice;
    }
    ready_.push_back(std::move(step));
    for (auto early = early_.begin(); early != early_.end() && early->first == next(); early = early_.erase(early))
      ready_.push_back(std::move(early->second));
    return Added::kInOrder;
  }

  // Steps in order; references to them stay valid.
  const std::deque<msg::Step>& ready() const { return ready_; }
  // The number of the first step that is not there.
  std::uint32_t next() const { return first_ + static_cast<std::uint32_t>(ready_.size()); }
  bool gap() const { return !early_.empty(); }

 private:
  static constexpr std::size_t kEarlyLimit = 65536;
  std::uint32_t first_;
  std::deque<msg::Step> ready_;
  std::map<std::uint32_t, msg::Step> early_;
};

}  // namespace foothold::client
