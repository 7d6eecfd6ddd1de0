// The requests that wait.
#include "jobs/queue.hpp"

namespace foothold::server {

void Queue::add(const std::string& robot, std::int32_t priority, std::uint64_t turn, const Id& id) {
  if (waiting_[robot].emplace(Place{priority, turn}, id).second) ++size_;
}

void Queue::remove(const std::string& robot, std::int32_t priority, std::uint64_t turn) {
  const auto found = waiting_.find(robot);
  if (found == waiting_.end() || found->second.erase(Place{priority, turn}) == 0) return;
  --size_;
  if (found->second.empty()) waiting_.erase(found);
}

Id Queue::take(const std::string& robot) {
  auto& places = waiting_.at(robot);
  const auto [place, id] = *places.begin();
  remove(robot, place.priority, place.turn);
  return id;
}

std::vector<Id> Queue::of(const std::string& robot) const {
  std::vector<Id> ids;
  const auto found = waiting_.find(robot);
  if (found == waiting_.end()) return ids;
  for (const auto& [place, id] : found->second) ids.push_back(id);
  return ids;
}

std::vector<std::string> Queue::robots() const {
  std::vector<std::string> names;
  for (const auto& [robot, places] : waiting_) names.push_back(robot);
  return names;
}

}  // namespace foothold::server
