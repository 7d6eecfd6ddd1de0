// The fleet as an observer sees it: servers by their heartbeats, robots by what servers announce, requests by the events in every
// client's partition.
#pragma once

#include <foothold.h>

#include <chrono>
#include <deque>
#include <map>
#include <mutex>
#include <string>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "foothold/msg/ids.hpp"

namespace foothold::cli {

// One picture of it. Times in seconds.
struct FleetPicture {
  struct Server {
    msg::ServerInfo info;
    bool alive = true;
  };
  struct Robot {
    msg::RobotInfo info;
    std::string server;         // its name
    std::uint32_t running = 0;  // of the requests below
  };
  struct Request {
    msg::PlanEvent event;  // the last change that was heard
    std::string server;
    double age = 0.0;  // since that change
  };
  std::vector<Server> servers;                          // by name
  std::vector<Robot> robots;                            // by name and server; of servers that are alive
  std::vector<Request> requests;                        // unfinished: RUNNING first, then by age, the oldest first
  std::vector<Request> ended;                           // the newest first
  std::map<std::string, std::uint64_t> ended_by_state;  // since the watching began
};

// Thread rule: any thread; the bus's fill it.
class Fleet {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr double kSilence = 1.5;            // s without a heartbeat after which a server counts as lost
  static constexpr std::size_t kEndedKept = 10;      // shown
  static constexpr std::size_t kMostKnown = 100000;  // requests remembered, so that an old event does not bring one back

  // `began`: ns since 1970; what ended before is not counted.
  explicit Fleet(std::int64_t began) : began_(began) {}

  void add(const msg::ServerInfo& server, Clock::time_point now);
  void add(const msg::RobotInfo& robot);
  void add(const msg::PlanEvent& event);
  // `stamp`: now, in ns since 1970.
  FleetPicture look(Clock::time_point now, std::int64_t stamp) const;
  bool has_server() const;

 private:
  struct Seen {
    msg::ServerInfo info;
    Clock::time_point beat;
  };
  void end(const msg::PlanEvent& event);
  std::string name_of(const msg::Id& server) const;

  const std::int64_t began_;
  mutable std::mutex mutex_;
  std::unordered_map<msg::Id, Seen, msg::IdHash> servers_;
  std::unordered_map<msg::Id, msg::RobotInfo, msg::IdHash> robots_;
  std::unordered_map<msg::Id, msg::PlanEvent, msg::IdHash> open_;
  std::unordered_set<msg::Id, msg::IdHash> over_;
  std::deque<msg::Id> over_order_;
  std::deque<msg::PlanEvent> ended_;
  std::map<std::string, std::uint64_t> ended_by_state_;
};

// One object on one line.
std::string to_json_line(const FleetPicture& picture);

}  // namespace foothold::cli
