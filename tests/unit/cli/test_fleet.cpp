// What `foothold top` makes of what it hears: late, twice, out of order and from servers that are gone.
#include <gtest/gtest.h>

#include "foothold/msg/errors.hpp"
#include "top/fleet.hpp"

namespace foothold::cli {
namespace {

constexpr std::int64_t kBegan = 1'700'000'000'000'000'000;
constexpr std::int64_t kSecond = 1'000'000'000;

class FleetTest : public testing::Test {
 protected:
  void beat(const std::string& name, double at = 0.0) {
    msg::ServerInfo info;
    info.name(name);
    info.key(msg::id_of(name));
    fleet_.add(info, time(at));
  }
  void event(const std::string& request, msg::State state, double at, const std::string& server = "a", std::uint16_t code = 0) {
    msg::PlanEvent told;
    told.request(msg::id_of(request));
    told.server(msg::id_of(server));
    told.robot("walker");
    told.unit("unit of " + request);
    told.state(state);
    told.stamp(kBegan + static_cast<std::int64_t>(at * 1e9));
    if (code != 0) told.error(msg::make_error(code, "why"));
    fleet_.add(told);
  }
  static Fleet::Clock::time_point time(double at) {
    return Fleet::Clock::time_point(std::chrono::milliseconds(3600000 + static_cast<int>(at * 1e3)));
  }
  FleetPicture look(double at = 0.0) const { return fleet_.look(time(at), kBegan + static_cast<std::int64_t>(at * 1e9)); }

  Fleet fleet_{kBegan};
};

TEST_F(FleetTest, AServerThatFallsSilentIsShownAsLostAndItsRobotsAreNot) {
  beat("a");
  beat("b", 2.0);
  msg::RobotInfo robot;
  robot.name("walker");
  robot.key(msg::id_of("walker at a"));
  robot.server(msg::id_of("a"));
  fleet_.add(robot);
  EXPECT_EQ(look(1.0).robots.size(), 1U);
  const FleetPicture picture = look(2.0);
  ASSERT_EQ(picture.servers.size(), 2U);
  EXPECT_FALSE(picture.servers[0].alive);
  EXPECT_TRUE(picture.servers[1].alive);
  EXPECT_TRUE(picture.robots.empty());
}

TEST_F(FleetTest, RequestsAreShownFromTheirFirstEventToTheirEndWhateverTheOrder) {
  beat("a");
  event("one", msg::QUEUED, 1.0);
  event("two", msg::RUNNING, 2.0);
  event("one", msg::RUNNING, 3.0);
  event("one", msg::QUEUED, 1.0);  // again, late
  FleetPicture picture = look(5.0);
  ASSERT_EQ(picture.requests.size(), 2U);
  EXPECT_EQ(picture.requests[0].event.unit(), "unit of two") << "the oldest first";
  EXPECT_EQ(picture.requests[1].event.state(), msg::RUNNING);
  EXPECT_NEAR(picture.requests[1].age, 2.0, 1e-6);
  event("one", msg::SUCCEEDED, 6.0);
  event("one", msg::RUNNING, 3.0);
  event("one", msg::SUCCEEDED, 6.0);  // an answer
  picture = look(7.0);
  EXPECT_EQ(picture.requests.size(), 1U);
  EXPECT_EQ(picture.ended_by_state.at("SUCCEEDED"), 1U);
  ASSERT_EQ(picture.ended.size(), 1U);
}

TEST_F(FleetTest, WhatEndedBeforeTheWatchingBeganIsNotCounted) {
  event("old", msg::SUCCEEDED, -5.0);
  event("old", msg::RUNNING, -6.0);
  const FleetPicture picture = look();
  EXPECT_TRUE(picture.requests.empty());
  EXPECT_TRUE(picture.ended.empty());
  EXPECT_TRUE(picture.ended_by_state.empty());
}

TEST_F(FleetTest, ARequestThatMovedToAnotherServerEndsThere) {
  beat("a");
  beat("b");
  event("moves", msg::RUNNING, 1.0, "a");
  event("moves", msg::RUNNING, 2.0, "b");
  event("moves", msg::CANCELLED, 3.0, "a", msg::MOVED);
  event("moves", msg::FAILED, 3.5, "a", msg::SERVER_RESTARTED);
  ASSERT_EQ(look(4.0).requests.size(), 1U);
  EXPECT_EQ(look(4.0).requests[0].server, "b");
  event("moves", msg::SUCCEEDED, 5.0, "b");
  EXPECT_TRUE(look(6.0).requests.empty());
  EXPECT_EQ(look(6.0).ended_by_state, (std::map<std::string, std::uint64_t>{{"SUCCEEDED", 1}}));
}

TEST_F(FleetTest, OnlyTheLatestEndsAreKept) {
  for (int i = 0; i < 50; ++i) event(std::to_string(i), msg::SUCCEEDED, 1.0 + i);
  const FleetPicture picture = look(60.0);
  ASSERT_EQ(picture.ended.size(), Fleet::kEndedKept);
  EXPECT_EQ(picture.ended[0].event.unit(), "unit of 49");
  EXPECT_EQ(picture.ended_by_state.at("SUCCEEDED"), 50U);
}

TEST_F(FleetTest, APictureIsOneLineOfJsonWhateverNamesHold) {
  beat("a \"quoted\"\nname\xff");
  event("one", msg::RUNNING, 1.0, "a \"quoted\"\nname\xff");
  const std::string line = to_json_line(look(2.0));
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_NE(line.find("\"unit\":\"unit of one\""), std::string::npos) << line;
  EXPECT_NE(line.find("a \\\"quoted\\\"\\nname"), std::string::npos) << line;
}

}  // namespace
}  // namespace foothold::cli
