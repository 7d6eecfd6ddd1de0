// Private: what servers announce: themselves, their robots, the scenes that they keep.
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "foothold/client/client.hpp"

namespace foothold::client {

// Any thread.
class Directory {
 public:
  using Clock = std::chrono::steady_clock;

  // Each returns true if somebody should know: a server that was not there before, or is back.
  bool add(const msg::ServerInfo& server, Clock::time_point now);
  void add(const msg::RobotInfo& robot);
  void add(const msg::SceneStatus& scene);
  // Servers that were alive and have not been heard for `silence`; all of them if `nobody_alive`.
  std::vector<msg::Id> silent(Clock::time_point now, double silence, bool nobody_alive);
  // Both ways to the servers are open.
  void set_open(bool open);

  std::vector<ServerSeen> servers() const;
  std::vector<msg::Id> alive() const;
  std::vector<msg::RobotInfo> robots() const;
  std::vector<msg::SceneStatus> scenes() const;
  std::optional<msg::RobotInfo> robot(std::string_view name, const msg::Id& server) const;
  // The alive server that has the robot and the least to do.
  std::optional<msg::Id> choose(std::string_view robot) const;
  // Answers to this upload are kept from now on, until it is forgotten.
  void expect(const msg::Id& upload);
  void forget(const msg::Id& upload);
  // What became of an upload: the answer to it, or, if any_of_it, the same file stored by whomever.
  std::optional<msg::SceneStatus> verdict(const msg::Id& upload, std::string_view name, std::string_view revision,
                                          bool any_of_it) const;

  bool wait_open(double seconds, const msg::Id& server) const;
  std::optional<msg::RobotInfo> wait_robot(std::string_view name, double seconds, const msg::Id& server) const;
  void wait_change(double seconds) const;
  Clock::time_point changed() const;

 private:
  struct Seen {
    ServerSeen server;
    Clock::time_point beat;
  };
  bool is_alive(const msg::Id& server) const;
  std::optional<msg::RobotInfo> find_robot(std::string_view name, const msg::Id& server) const;
  void tell();

  mutable std::mutex mutex_;
  mutable std::condition_variable news_;
  std::unordered_map<msg::Id, Seen, msg::IdHash> servers_;
  std::unordered_map<msg::Id, msg::RobotInfo, msg::IdHash> robots_;
  std::unordered_map<msg::Id, msg::SceneStatus, msg::IdHash> scenes_;
  std::unordered_map<msg::Id, std::optional<msg::SceneStatus>, msg::IdHash> uploads_;  // that are expected
  bool open_ = false;
  Clock::time_point changed_ = Clock::now();
};

}  // namespace foothold::client
