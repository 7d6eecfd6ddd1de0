// The requests that wait.
#include "jobs/queue.hpp"

#include <set>
#include <utility>

namespace foothold::server {

void Queue::add(const Place& place, const Id& id) {
  const auto [line, is_new] = waiting_[place.robot][place.priority].try_emplace(place.client);
  if (is_new) line->second.last_turn = ++served_;
  if (!line->second.requests.emplace(place.turn, id).second) return;
  ++size_;
  ++of_client_[place.client];
}

void Queue::remove(const Place& place) {
  const auto levels = waiting_.find(place.robot);
  if (levels == waiting_.end()) return;
  const auto level = levels->second.find(place.priority);
  if (level == levels->second.end()) return;
  const auto line = level->second.find(place.client);
  if (line == level->second.end() || line->second.requests.erase(place.turn) == 0) return;
  --size_;
  if (--of_client_.at(place.client) == 0) of_client_.erase(place.client);
  if (!line->second.requests.empty()) return;
  level->second.erase(line);
  if (level->second.empty()) levels->second.erase(level);
  if (levels->second.empty()) waiting_.erase(levels);
}

void Queue::take(const Place& place) {
  waiting_.at(place.robot).at(place.priority).at(place.client).last_turn = ++served_;
  remove(place);
}

std::optional<Id> Queue::next(const std::string& robot, const Shares& shares, std::size_t most_running) const {
  const auto levels = waiting_.find(robot);
  if (levels == waiting_.end()) return std::nullopt;
  for (const auto& [priority, level] : levels->second) {
    std::optional<std::pair<std::size_t, std::uint64_t>> best;
    const Line* chosen = nullptr;
    for (const auto& [client, line] : level) {
      if (most_running != 0 && shares.of(client) >= most_running) continue;
      const std::pair rank(shares.of(client, robot), line.last_turn);
      if (best && *best <= rank) continue;
      best = rank;
      chosen = &line;
    }
    if (chosen != nullptr) return chosen->requests.begin()->second;
  }
  return std::nullopt;
}

std::size_t Queue::of_client(const Id& client) const {
  const auto found = of_client_.find(client);
  return found == of_client_.end() ? 0 : found->second;
}

std::size_t Queue::clients(const std::string& robot) const {
  const auto levels = waiting_.find(robot);
  if (levels == waiting_.end()) return 0;
  std::set<Id> names;
  for (const auto& [priority, level] : levels->second)
    for (const auto& [client, line] : level) names.insert(client);
  return names.size();
}

std::vector<Id> Queue::of(const std::string& robot) const {
  std::vector<Id> ids;
  const auto levels = waiting_.find(robot);
  if (levels == waiting_.end()) return ids;
  for (const auto& [priority, level] : levels->second)
    for (const auto& [client, line] : level)
      for (const auto& [turn, id] : line.requests) ids.push_back(id);
  return ids;
}

std::vector<std::string> Queue::robots() const {
  std::vector<std::string> names;
  for (const auto& [robot, levels] : waiting_) names.push_back(robot);
  return names;
}

}  // namespace foothold::server
