// Cancels that came before their requests, remembered for a while (idl/PROTOCOL.md P11).
#pragma once

#include <deque>
#include <optional>
#include <unordered_map>

#include "jobs/ports.hpp"

namespace foothold::server {

class EarlyCancels {
 public:
  static constexpr std::size_t kMost = 10000;

  // False if as many are remembered as may be.
  bool remember(const Id& request, Time until, msg::CancelRequest cancel);
  // The cancel of this request if one is remembered; it is forgotten then.
  std::optional<msg::CancelRequest> take(const Id& request, Time now);
  void forget_old(Time now);
  std::optional<Time> next() const;

 private:
  struct Entry {
    Time until;
    msg::CancelRequest cancel;
  };
  std::unordered_map<Id, Entry, msg::IdHash> entries_;
  std::deque<std::pair<Time, Id>> order_;  // may name what is taken already
};

}  // namespace foothold::server
