// More than one server: which one is asked.
#include <gtest/gtest.h>

#include <algorithm>

#include "directory.hpp"
#include "foothold/msg/errors.hpp"
#include "foothold/msg/ids.hpp"

namespace foothold::test {
namespace {

class Choice : public testing::Test {
 protected:
  void server(const std::string& name, std::uint32_t queued, std::uint32_t running, std::uint32_t slots, bool stopping = false) {
    msg::ServerInfo info;
    info.key(msg::id_of(name));
    info.queued(queued);
    info.running(running);
    info.slots(slots);
    info.stopping(stopping);
    directory_.add(info, now_);
    robot(name, msg::READY);
  }
  void robot(const std::string& name, msg::RobotState state) {
    msg::RobotInfo robot;
    robot.key(msg::id_of(name + " robot"));
    robot.server(msg::id_of(name));
    robot.name("robot");
    robot.state(state);
    directory_.add(robot);
  }
  void scene(const std::string& name, const std::string& revision, std::int64_t stamp) {
    msg::SceneStatus status;
    status.key(msg::id_of(name + revision));
    status.server(msg::id_of(name));
    status.name("yard");
    status.revision(revision);
    status.stamp(stamp);
    directory_.add(status);
  }
  bool chooses(const std::string& name) { return directory_.choose(request_) == msg::id_of(name); }

  client::Directory directory_{msg::id_of("client")};
  client::Directory::Clock::time_point now_ = client::Directory::Clock::now();
  msg::PlanRequest request_ = [] {
    msg::PlanRequest request;
    request.robot("robot");
    return request;
  }();
};

TEST_F(Choice, TheLeastLoadedForItsWorkers) {
  server("small", 0, 1, 1);
  server("large", 1, 3, 8);
  EXPECT_TRUE(chooses("large"));
}

TEST_F(Choice, RequestsThatNoHeartbeatCountsYetCountToo) {
  server("one", 0, 0, 2);
  server("two", 0, 0, 2);
  std::map<msg::Id, int> given;
  for (int i = 0; i < 100; ++i) ++given[*directory_.choose(request_)];
  EXPECT_EQ(given[msg::id_of("one")], 50);
  EXPECT_EQ(given[msg::id_of("two")], 50);
}

TEST_F(Choice, ClientsThatSeeTheSameDoNotAllChooseTheSame) {
  std::map<msg::Id, int> given;
  for (int i = 0; i < 64; ++i) {
    client::Directory directory(msg::id_of("client " + std::to_string(i)));
    for (const char* name : {"one", "two"}) {
      msg::ServerInfo info;
      info.key(msg::id_of(name));
      info.slots(1);
      directory.add(info, now_);
      msg::RobotInfo robot;
      robot.key(msg::id_of(name));
      robot.server(msg::id_of(name));
      robot.name("robot");
      robot.state(msg::READY);
      directory.add(robot);
    }
    ++given[*directory.choose(request_)];
  }
  EXPECT_GT(given[msg::id_of("one")], 16);
  EXPECT_GT(given[msg::id_of("two")], 16);
}

TEST_F(Choice, ABusyServerThatCanComesBeforeAnIdleOneThatCannot) {
  server("busy", 50, 2, 2);
  server("stopping", 0, 0, 2, true);
  server("quarantined", 0, 0, 2);
  robot("quarantined", msg::QUARANTINED);
  EXPECT_TRUE(chooses("busy"));
  EXPECT_FALSE(directory_.choose(request_, std::vector{msg::id_of("busy")}, true)) << "of those, none is able";
  EXPECT_TRUE(directory_.choose(request_, std::vector{msg::id_of("busy")}, false)) << "but will say why";
}

TEST_F(Choice, OneThatHasTheSceneAndItsRevision) {
  server("without", 0, 0, 8);
  server("with old", 0, 1, 2);
  server("with both", 5, 2, 2);
  scene("with old", "r1", 1);
  scene("with both", "r1", 1);
  scene("with both", "r2", 2);
  request_.scene("yard");
  EXPECT_TRUE(chooses("with old"));
  request_.scene_revision("r2");
  EXPECT_TRUE(chooses("with both"));
  EXPECT_EQ(directory_.newest("yard", msg::id_of("with both")), "r2");
  EXPECT_EQ(directory_.newest("yard", msg::id_of("without")), "");
}

TEST_F(Choice, ASilentServerIsLostSoonerIfTheVendorMissesOneToo) {
  server("one", 0, 0, 1);
  const auto later = now_ + std::chrono::milliseconds(900);
  msg::ServerInfo info;
  info.key(msg::id_of("two"));
  directory_.add(info, later);
  EXPECT_FALSE(directory_.mark_silent(later, 1.5, 2));
  EXPECT_TRUE(directory_.mark_silent(later, 1.5, 1));
  EXPECT_EQ(directory_.alive(), std::vector{msg::id_of("two")});
  EXPECT_TRUE(directory_.mark_silent(later, 1.5, 0));
  EXPECT_TRUE(directory_.alive().empty());
}

}  // namespace
}  // namespace foothold::test
