// Who has how much of the workers: plans that run, by client and robot.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>

#include "jobs/ports.hpp"

namespace foothold::server {

class Shares {
 public:
  void began(const Id& client, const std::string& robot) {
    Share& share = shares_[client];
    ++share.all;
    ++share.of_robot[robot];
  }
  // Precondition: it began.
  void over(const Id& client, const std::string& robot) {
    const auto share = shares_.find(client);
    if (--share->second.of_robot.at(robot) == 0) share->second.of_robot.erase(robot);
    if (--share->second.all == 0) shares_.erase(share);
  }

  std::size_t of(const Id& client) const {
    const auto share = shares_.find(client);
    return share == shares_.end() ? 0 : share->second.all;
  }
  std::size_t of(const Id& client, const std::string& robot) const {
    const auto share = shares_.find(client);
    if (share == shares_.end()) return 0;
    const auto count = share->second.of_robot.find(robot);
    return count == share->second.of_robot.end() ? 0 : count->second;
  }

 private:
  struct Share {
    std::size_t all = 0;
    std::map<std::string, std::size_t, std::less<>> of_robot;
  };
  std::unordered_map<Id, Share, msg::IdHash> shares_;  // no client with nothing
};

}  // namespace foothold::server
