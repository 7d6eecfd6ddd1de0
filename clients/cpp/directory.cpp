// Announcements of servers, and waiting for them.
#include "directory.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace foothold::client {
namespace {

std::chrono::steady_clock::duration from_seconds(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(std::min(seconds, 1e9)));
}

}  // namespace

void Directory::tell() {
  changed_ = Clock::now();
  news_.notify_all();
}

bool Directory::add(const msg::ServerInfo& server, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  const auto [seen, is_new] = servers_.try_emplace(server.key());
  const bool back = is_new || !seen->second.server.alive;
  seen->second = {{server, true}, now, 0, back ? now : seen->second.since};
  if (back) tell();
  return back;
}

void Directory::add(const msg::RobotInfo& robot) {
  const std::lock_guard lock(mutex_);
  robots_[robot.key()] = robot;
  tell();
}

void Directory::add(const msg::SceneStatus& scene) {
  const std::lock_guard lock(mutex_);
  if (scene.state() == msg::STORED) scenes_[scene.key()] = scene;
  if (const auto upload = uploads_.find(scene.upload()); upload != uploads_.end()) upload->second.push_back(scene);
  tell();
}

void Directory::expect(const msg::Id& upload) {
  const std::lock_guard lock(mutex_);
  uploads_.try_emplace(upload);
}

void Directory::forget(const msg::Id& upload) {
  const std::lock_guard lock(mutex_);
  uploads_.erase(upload);
}

bool Directory::mark_silent(Clock::time_point now, double silence, std::size_t writers_alive) {
  const std::lock_guard lock(mutex_);
  const auto alive = [](const auto& entry) { return entry.second.server.alive; };
  const auto known = static_cast<std::size_t>(std::ranges::count_if(servers_, alive));
  const double limit = writers_alive == 0 ? 0.0 : writers_alive < known ? silence / 2.0 : silence;
  bool any = false;
  for (auto& [id, seen] : servers_) {
    if (!seen.server.alive || now - seen.beat < from_seconds(limit)) continue;
    seen.server.alive = false;
    any = true;
  }
  if (any) tell();
  return any;
}

void Directory::forgive_silence(Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  for (auto& [id, seen] : servers_)
    if (seen.server.alive) seen.beat = now;
}

void Directory::set_open(bool open) {
  const std::lock_guard lock(mutex_);
  if (open_ == open) return;
  open_ = open;
  news_.notify_all();
}

std::vector<ServerSeen> Directory::servers() const {
  const std::lock_guard lock(mutex_);
  std::vector<ServerSeen> list;
  for (const auto& [id, seen] : servers_) list.push_back(seen.server);
  std::ranges::sort(list, [](const auto& a, const auto& b) {
    return std::tie(a.info.name(), a.info.key()) < std::tie(b.info.name(), b.info.key());
  });
  return list;
}

std::vector<msg::Id> Directory::alive() const {
  const std::lock_guard lock(mutex_);
  std::vector<msg::Id> list;
  for (const auto& [id, seen] : servers_)
    if (seen.server.alive) list.push_back(id);
  return list;
}

std::vector<msg::RobotInfo> Directory::robots() const {
  const std::lock_guard lock(mutex_);
  std::vector<msg::RobotInfo> list;
  for (const auto& [key, robot] : robots_)
    if (is_alive(robot.server())) list.push_back(robot);
  std::ranges::sort(list,
                    [](const auto& a, const auto& b) { return std::tie(a.name(), a.server()) < std::tie(b.name(), b.server()); });
  return list;
}

std::vector<msg::SceneStatus> Directory::scenes() const {
  const std::lock_guard lock(mutex_);
  std::vector<msg::SceneStatus> list;
  for (const auto& [key, scene] : scenes_)
    if (is_alive(scene.server())) list.push_back(scene);
  std::ranges::sort(list, [](const auto& a, const auto& b) {
    return std::make_tuple(a.name(), a.stamp(), a.revision()) < std::make_tuple(b.name(), b.stamp(), b.revision());
  });
  return list;
}

bool Directory::is_alive(const msg::Id& server) const {
  const auto seen = servers_.find(server);
  return seen != servers_.end() && seen->second.server.alive;
}

std::optional<msg::RobotInfo> Directory::find_robot(std::string_view name, const msg::Id& server) const {
  for (const auto& [key, robot] : robots_)
    if (robot.name() == name && is_alive(robot.server()) && (server == msg::kNoId || robot.server() == server)) return robot;
  return std::nullopt;
}

std::optional<msg::RobotInfo> Directory::robot(std::string_view name, const msg::Id& server) const {
  const std::lock_guard lock(mutex_);
  return find_robot(name, server);
}

bool Directory::has_scene(const msg::Id& server, const msg::PlanRequest& request) const {
  return request.scene().empty() || std::ranges::any_of(scenes_, [&](const auto& entry) {
           const msg::SceneStatus& scene = entry.second;
           return scene.server() == server && scene.name() == request.scene() &&
                  (request.scene_revision().empty() || scene.revision() == request.scene_revision());
         });
}

std::string Directory::newest(std::string_view name, const msg::Id& server) const {
  const std::lock_guard lock(mutex_);
  const msg::SceneStatus* best = nullptr;
  for (const auto& [key, scene] : scenes_)
    if (scene.server() == server && scene.name() == name && (best == nullptr || scene.stamp() > best->stamp())) best = &scene;
  return best == nullptr ? std::string() : best->revision();
}

std::vector<msg::Id> Directory::without_scene(std::string_view name, Clock::time_point since) const {
  const std::lock_guard lock(mutex_);
  std::vector<msg::Id> list;
  for (const auto& [id, seen] : servers_) {
    const auto has_it = [&name, &id = id](const auto& entry) { return entry.second.server() == id && entry.second.name() == name; };
    if (seen.server.alive && seen.since <= since && std::ranges::none_of(scenes_, has_it)) list.push_back(id);
  }
  return list;
}

bool Directory::is_superseded(std::string_view name, std::string_view revision) const {
  const std::lock_guard lock(mutex_);
  const msg::SceneStatus* newest = nullptr;
  for (const auto& [key, scene] : scenes_)
    if (scene.name() == name && (newest == nullptr || scene.stamp() > newest->stamp())) newest = &scene;
  return newest != nullptr && newest->revision() != revision;
}

bool Directory::is_there(const msg::Id& server) const {
  const std::lock_guard lock(mutex_);
  return is_alive(server);
}

std::optional<msg::Id> Directory::choose(const msg::PlanRequest& request, std::span<const msg::Id> except, bool able) {
  const std::lock_guard lock(mutex_);
  const auto rank = [&](const msg::RobotInfo& robot, const Seen& seen) {
    const msg::ServerInfo& server = seen.server.info;
    const double work = static_cast<double>(server.queued() + server.running() + seen.given) / std::max(1u, server.slots());
    msg::Id order = server.key();
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint8_t>(order[i] ^ client_[i]);
    return std::make_tuple(robot.state() != msg::READY || server.stopping(), !has_scene(server.key(), request), work, order);
  };
  std::optional<decltype(rank(std::declval<msg::RobotInfo>(), std::declval<Seen>()))> best_rank;
  Seen* best = nullptr;
  for (const auto& [key, robot] : robots_) {
    if (robot.name() != request.robot() || !is_alive(robot.server())) continue;
    if (std::ranges::find(except, robot.server()) != except.end()) continue;
    Seen& seen = servers_.at(robot.server());
    const auto its_rank = rank(robot, seen);
    if (able && (std::get<0>(its_rank) || std::get<1>(its_rank))) continue;
    if (best_rank && *best_rank <= its_rank) continue;
    best = &seen;
    best_rank = its_rank;
  }
  if (best == nullptr) return std::nullopt;
  ++best->given;
  return best->server.info.key();
}

std::optional<msg::SceneStatus> Directory::verdict(const msg::Id& upload, std::span<const msg::Id> servers, std::string_view name,
                                                   std::string_view revision, bool any_of_it) const {
  const std::lock_guard lock(mutex_);
  const auto answer_of = [&](const msg::Id& server) -> const msg::SceneStatus* {
    if (const auto answers = uploads_.find(upload); answers != uploads_.end())
      for (const auto& answer : answers->second)
        if (answer.server() == server) return &answer;
    if (any_of_it)
      for (const auto& [key, scene] : scenes_)
        if (scene.server() == server && scene.name() == name && scene.revision() == revision) return &scene;
    return nullptr;
  };
  const msg::SceneStatus* found = nullptr;
  for (const msg::Id& server : servers) {
    if (!is_alive(server)) continue;
    const msg::SceneStatus* answer = answer_of(server);
    if (answer == nullptr) return std::nullopt;
    if (found == nullptr || answer->state() == msg::REFUSED) found = answer;
  }
  return found == nullptr ? std::nullopt : std::optional(*found);
}

bool Directory::wait_open(double seconds, const msg::Id& server) const {
  std::unique_lock lock(mutex_);
  return news_.wait_for(lock, from_seconds(seconds), [&] {
    if (!open_) return false;
    if (server != msg::kNoId) return is_alive(server);
    return std::ranges::any_of(servers_, [](const auto& entry) { return entry.second.server.alive; });
  });
}

std::optional<msg::RobotInfo> Directory::wait_robot(std::string_view name, double seconds, const msg::Id& server) const {
  std::unique_lock lock(mutex_);
  std::optional<msg::RobotInfo> robot;
  news_.wait_for(lock, from_seconds(seconds), [&] { return (robot = find_robot(name, server)).has_value(); });
  return robot;
}

void Directory::wait_change(double seconds) const {
  std::unique_lock lock(mutex_);
  news_.wait_for(lock, from_seconds(seconds), [&, before = changed_] { return changed_ != before; });
}

Directory::Clock::time_point Directory::changed() const {
  const std::lock_guard lock(mutex_);
  return changed_;
}

}  // namespace foothold::client
