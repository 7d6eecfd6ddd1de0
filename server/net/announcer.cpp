// The server's words to everybody.
#include "net/announcer.hpp"

#include "foothold/msg/cdr.hpp"

namespace foothold::server {

using transport::Topic;

Announcer::Announcer(transport::Bus& bus, const Id& server)
    : server_(server),
      server_writer_(bus.writer(Topic::kServer, "")),
      robot_writer_(bus.writer(Topic::kRobot, "")),
      scene_writer_(bus.writer(Topic::kSceneStatus, "")) {}

void Announcer::robot(const std::shared_ptr<const msg::RobotInfo>& info) {
  Robot& robot = robots_[info->name()];
  if (robot.info == info) return;
  robot.info = info;
  msg::RobotInfo told = *info;
  told.key(msg::id_of(msg::to_hex(server_) + "/robot/" + info->name()));
  told.server(server_);
  robot.kept = {msg::encode(told), false};
  send(*robot_writer_, robot.kept);
}

void Announcer::scene(msg::SceneStatus status) {
  status.server(server_);
  Kept& kept = scenes_[status.key()];
  kept = {msg::encode(status), false};
  send(*scene_writer_, kept);
}

void Announcer::beat(msg::ServerInfo info) {
  info.key(server_);
  info.heartbeat(++beats_);
  server_writer_->write(msg::encode(info));  // one that is lost is made up for by the next
  server_writer_->assert_liveliness();
  for (auto& [name, robot] : robots_)
    if (!robot.kept.sent) send(*robot_writer_, robot.kept);
  for (auto& [key, kept] : scenes_)
    if (!kept.sent) send(*scene_writer_, kept);
}

void Announcer::send(transport::Writer& writer, Kept& kept) {
  kept.sent = writer.write(kept.bytes) != transport::Writer::Result::kFull;
}

std::size_t Announcer::matched(Topic topic) const {
  const auto& writer = topic == Topic::kServer ? server_writer_ : topic == Topic::kRobot ? robot_writer_ : scene_writer_;
  return writer->matched();
}

bool Announcer::wait_acknowledged(double seconds) { return server_writer_->wait_acknowledged(seconds); }

}  // namespace foothold::server
