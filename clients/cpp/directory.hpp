// Private: what servers announce: themselves, their robots, the scenes that they keep.
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "foothold/client/client.hpp"

namespace foothold::client {

// Any thread.
class Directory {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Directory(const msg::Id& client) : client_(client) {}

  // Each returns true if somebody should know: a server that was not there before, or is back.
  bool add(const msg::ServerInfo& server, Clock::time_point now);
  void add(const msg::RobotInfo& robot);
  void add(const msg::SceneStatus& scene);
  // Marks servers that were alive and have not been heard for `silence`, or half of it if the vendor counts only `writers_alive`
  // of them; all if it counts none. True if there was one.
  bool mark_silent(Clock::time_point now, double silence, std::size_t writers_alive);
  // This process was halted: it cannot know who was silent meanwhile.
  void forgive_silence(Clock::time_point now);
  // Both ways to the servers are open.
  void set_open(bool open);

  std::vector<ServerSeen> servers() const;
  std::vector<msg::Id> alive() const;
  std::vector<msg::RobotInfo> robots() const;
  std::vector<msg::SceneStatus> scenes() const;
  std::optional<msg::RobotInfo> robot(std::string_view name, const msg::Id& server) const;
  // The alive server that has the request's robot and scene and the least to do, counting what choose() gave it since its last
  // heartbeat; servers that have equally much in an order of this client's own. One that stops, whose robot is not ready or that
  // has not told of the scene comes last: it still answers, with the reason.
  // None of `except`, and if `able` none of those that come last.
  std::optional<msg::Id> choose(const msg::PlanRequest& request, std::span<const msg::Id> except = {}, bool able = false);
  // The newest revision of a scene as this server told; empty if it did not.
  std::string newest(std::string_view scene, const msg::Id& server) const;
  // Servers that are alive, since then or longer, and have told of no scene of this name.
  std::vector<msg::Id> without_scene(std::string_view scene, Clock::time_point since) const;
  // Another revision of this scene was stored anywhere later than this one.
  bool is_superseded(std::string_view scene, std::string_view revision) const;
  bool is_there(const msg::Id& server) const;  // alive
  // Answers to this upload are kept from now on, until it is forgotten.
  void expect(const msg::Id& upload);
  void forget(const msg::Id& upload);
  // What became of an upload at those servers that are still alive: a refusal if there is one; nothing while an answer is missing
  // or none of them is alive. A server's answer is the one to this upload or, if any_of_it, that it has the same file from
  // whomever.
  std::optional<msg::SceneStatus> verdict(const msg::Id& upload, std::span<const msg::Id> servers, std::string_view name,
                                          std::string_view revision, bool any_of_it) const;

  bool wait_open(double seconds, const msg::Id& server) const;
  std::optional<msg::RobotInfo> wait_robot(std::string_view name, double seconds, const msg::Id& server) const;
  void wait_change(double seconds) const;
  Clock::time_point changed() const;

 private:
  struct Seen {
    ServerSeen server;
    Clock::time_point beat;
    std::uint32_t given = 0;  // requests since
    Clock::time_point since;  // alive without a break
  };
  bool is_alive(const msg::Id& server) const;
  bool has_scene(const msg::Id& server, const msg::PlanRequest& request) const;
  std::optional<msg::RobotInfo> find_robot(std::string_view name, const msg::Id& server) const;
  void tell();

  const msg::Id client_;
  mutable std::mutex mutex_;
  mutable std::condition_variable news_;
  std::unordered_map<msg::Id, Seen, msg::IdHash> servers_;
  std::unordered_map<msg::Id, msg::RobotInfo, msg::IdHash> robots_;
  std::unordered_map<msg::Id, msg::SceneStatus, msg::IdHash> scenes_;
  std::unordered_map<msg::Id, std::vector<msg::SceneStatus>, msg::IdHash> uploads_;  // answers to those that are expected
  bool open_ = false;
  Clock::time_point changed_ = Clock::now();
};

}  // namespace foothold::client
