// The requests that wait, each for a slot of its robot (idl/PROTOCOL.md P7, P32, P33): higher priority first; within a priority the
// client that holds the fewest of the robot's slots, and among those the one whose last turn is the longest ago; of one client the
// earlier request.
//
// One slot is thus shared by turns: while a client waits, no other starts twice. Of k slots, each of n clients that wait has k / n,
// rounded down, however long its plans last and however many it sends.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "jobs/ports.hpp"
#include "jobs/shares.hpp"

namespace foothold::server {

class Queue {
 public:
  struct Place {
    std::string robot;
    std::int32_t priority = 0;
    Id client{};
    std::uint64_t turn = 0;  // place in the order of receipt, unique
  };

  void add(const Place& place, const Id& id);
  void remove(const Place& place);
  // Who goes next for this robot; nothing if nobody may. A client with `most_running` plans, of all robots, waits (0: no limit).
  std::optional<Id> next(const std::string& robot, const Shares& shares, std::size_t most_running) const;
  // Takes a request out because it starts: its client's turn.
  void take(const Place& place);

  bool empty(const std::string& robot) const { return !waiting_.contains(robot); }
  std::size_t size() const { return size_; }
  std::size_t of_client(const Id& client) const;
  std::size_t clients(const std::string& robot) const;  // that wait for it
  std::vector<Id> of(const std::string& robot) const;   // by priority, then client
  std::vector<std::string> robots() const;              // those that something waits for

 private:
  // What one client waits for at one robot with one priority. None is empty.
  struct Line {
    std::uint64_t last_turn = 0;  // or when it began to wait
    std::map<std::uint64_t, Id> requests;
  };
  using Level = std::map<Id, Line>;
  using Levels = std::map<std::int32_t, Level, std::greater<>>;

  std::map<std::string, Levels, std::less<>> waiting_;
  std::unordered_map<Id, std::size_t, msg::IdHash> of_client_;
  std::size_t size_ = 0;
  std::uint64_t served_ = 0;
};

}  // namespace foothold::server
