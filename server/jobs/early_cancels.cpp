// Cancels that came before their requests.
#include "jobs/early_cancels.hpp"

namespace foothold::server {

bool EarlyCancels::remember(const Id& request, Time until, msg::CancelRequest cancel) {
  if (entries_.contains(request)) return true;  // the first one counts, and its time
  if (order_.size() >= kMost) return false;
  entries_.emplace(request, Entry{until, std::move(cancel)});
  order_.emplace_back(until, request);
  return true;
}

std::optional<msg::CancelRequest> EarlyCancels::take(const Id& request, Time now) {
  forget_old(now);
  const auto found = entries_.find(request);
  if (found == entries_.end()) return std::nullopt;
  auto cancel = std::move(found->second.cancel);
  entries_.erase(found);
  return cancel;
}

void EarlyCancels::forget_old(Time now) {
  while (!order_.empty() && order_.front().first <= now) {
    const auto found = entries_.find(order_.front().second);
    if (found != entries_.end() && found->second.until <= now) entries_.erase(found);
    order_.pop_front();
  }
}

std::optional<Time> EarlyCancels::next() const {
  if (order_.empty()) return std::nullopt;
  return order_.front().first;
}

}  // namespace foothold::server
