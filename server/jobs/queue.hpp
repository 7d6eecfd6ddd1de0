// The requests that wait, each for a slot of its robot: higher priority first, then the earlier (idl/PROTOCOL.md P7).
#pragma once

#include <compare>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "jobs/ports.hpp"

namespace foothold::server {

class Queue {
 public:
  // `turn`: place in the order of receipt, unique.
  void add(const std::string& robot, std::int32_t priority, std::uint64_t turn, const Id& id);
  void remove(const std::string& robot, std::int32_t priority, std::uint64_t turn);
  // Takes the next one of this robot. Precondition: !empty(robot).
  Id take(const std::string& robot);
  bool empty(const std::string& robot) const { return !waiting_.contains(robot); }
  std::size_t size() const { return size_; }
  std::vector<Id> of(const std::string& robot) const;  // in the order in which they would go
  std::vector<std::string> robots() const;             // those that something waits for

 private:
  struct Place {
    std::int32_t priority;
    std::uint64_t turn;
    bool operator<(const Place& other) const { return priority != other.priority ? priority > other.priority : turn < other.turn; }
  };
  std::map<std::string, std::map<Place, Id>, std::less<>> waiting_;  // no robot with nothing
  std::size_t size_ = 0;
};

}  // namespace foothold::server
