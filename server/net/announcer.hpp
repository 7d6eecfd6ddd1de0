// What the server says of itself to everybody: its heartbeat, its robots, its scenes.
#pragma once

#include <memory>
#include <string>
#include <unordered_map>

#include "foothold/transport/bus.hpp"
#include "jobs/ports.hpp"

namespace foothold::server {

// Thread rule: the loop.
class Announcer {
 public:
  // Throws BusError.
  Announcer(transport::Bus& bus, const Id& server);

  // `key` and `server` are filled in. The same object again costs nothing.
  void robot(const std::shared_ptr<const msg::RobotInfo>& info);
  void scene(msg::SceneStatus status);
  // Heartbeat; asserts this server's liveliness, too. `info.key` and the counter are filled in.
  void beat(msg::ServerInfo info);
  bool wait_acknowledged(double seconds);
  // Readers matched now, of kServer, kRobot or kSceneStatus.
  std::size_t matched(transport::Topic topic) const;

 private:
  struct Kept {
    Bytes bytes;
    bool sent = false;
  };
  struct Robot {
    std::shared_ptr<const msg::RobotInfo> info;
    Kept kept;
  };

  void send(transport::Writer& writer, Kept& kept);

  Id server_;
  std::uint64_t beats_ = 0;
  std::unique_ptr<transport::Writer> server_writer_, robot_writer_, scene_writer_;
  std::unordered_map<std::string, Robot> robots_;
  std::unordered_map<Id, Kept, msg::IdHash> scenes_;  // what could not be sent is tried again with the next beat
};

}  // namespace foothold::server
