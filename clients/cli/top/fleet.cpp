// The fleet as an observer sees it.
#include "top/fleet.hpp"

#include <algorithm>

#include "foothold/msg/errors.hpp"

namespace foothold::cli {

void Fleet::add(const msg::ServerInfo& server, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  servers_[server.key()] = {server, now};
}

void Fleet::add(const msg::RobotInfo& robot) {
  const std::lock_guard lock(mutex_);
  robots_[robot.key()] = robot;
}

// Events of a request may come late, twice, or from before the watching began; its end is the last that counts.
void Fleet::add(const msg::PlanEvent& event) {
  if (event.state() == msg::UNKNOWN || event.request() == msg::kNoId) return;
  const std::lock_guard lock(mutex_);
  if (over_.contains(event.request())) return;
  const auto known = open_.find(event.request());
  if (msg::is_final(event.state())) {
    // A client has moved it to another server: what the first one says of it is no end.
    const bool left = event.error().code() == msg::MOVED || event.error().code() == msg::SERVER_RESTARTED;
    const bool elsewhere = known != open_.end() && known->second.server() != event.server();
    if (event.error().code() != msg::MOVED && !(left && elsewhere)) end(event);
    return;
  }
  if (known == open_.end() && open_.size() >= kMostKnown) return;
  if (known == open_.end() || known->second.stamp() <= event.stamp()) open_[event.request()] = event;
}

void Fleet::end(const msg::PlanEvent& event) {
  open_.erase(event.request());
  over_.insert(event.request());
  over_order_.push_back(event.request());
  if (over_order_.size() > kMostKnown) {
    over_.erase(over_order_.front());
    over_order_.pop_front();
  }
  if (event.stamp() < began_) return;
  ++ended_by_state_[std::string(msg::state_name(event.state()))];
  ended_.push_front(event);
  if (ended_.size() > kEndedKept) ended_.pop_back();
}

bool Fleet::has_server() const {
  const std::lock_guard lock(mutex_);
  return !servers_.empty();
}

std::string Fleet::name_of(const msg::Id& server) const {
  const auto known = servers_.find(server);
  return known == servers_.end() ? msg::to_hex(server).substr(0, 8) : known->second.info.name();
}

FleetPicture Fleet::look(Clock::time_point now, std::int64_t stamp) const {
  const std::lock_guard lock(mutex_);
  FleetPicture picture;
  const auto alive = [&](const msg::Id& server) {
    const auto known = servers_.find(server);
    return known != servers_.end() && std::chrono::duration<double>(now - known->second.beat).count() < kSilence;
  };
  const auto shown = [&](const msg::PlanEvent& event) {
    return FleetPicture::Request{event, name_of(event.server()),
                                 1e-9 * static_cast<double>(std::max<std::int64_t>(0, stamp - event.stamp()))};
  };
  for (const auto& [id, seen] : servers_) picture.servers.push_back({seen.info, alive(id)});
  std::ranges::sort(picture.servers, [](const auto& a, const auto& b) {
    return std::tie(a.info.name(), a.info.key()) < std::tie(b.info.name(), b.info.key());
  });
  for (const auto& [id, event] : open_) picture.requests.push_back(shown(event));
  std::ranges::sort(picture.requests, [](const auto& a, const auto& b) {
    return std::make_tuple(a.event.state() != msg::RUNNING, a.event.stamp(), a.event.request()) <
           std::make_tuple(b.event.state() != msg::RUNNING, b.event.stamp(), b.event.request());
  });
  for (const auto& [key, robot] : robots_) {
    if (!alive(robot.server())) continue;
    const auto running = std::ranges::count_if(open_, [&](const auto& entry) {
      return entry.second.state() == msg::RUNNING && entry.second.server() == robot.server() &&
             entry.second.robot() == robot.name();
    });
    picture.robots.push_back({robot, name_of(robot.server()), static_cast<std::uint32_t>(running)});
  }
  std::ranges::sort(picture.robots, [](const auto& a, const auto& b) {
    return std::tie(a.info.name(), a.server) < std::tie(b.info.name(), b.server);
  });
  for (const auto& event : ended_) picture.ended.push_back(shown(event));
  picture.ended_by_state = ended_by_state_;
  return picture;
}

}  // namespace foothold::cli
