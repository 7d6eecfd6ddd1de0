// Two servers in one domain, of both vendors and mixed; one is killed, halted or stopped in the middle: P34 to P39.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <thread>

#include "daemon.hpp"
#include "eventually.hpp"
#include "foothold/client/client.hpp"
#include "foothold/msg/errors.hpp"
#include "planners.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

struct Fleet {
  const char *one, *two, *client;
  friend std::ostream& operator<<(std::ostream& out, const Fleet& fleet) {
    return out << fleet.one << " and " << fleet.two << " servers, " << fleet.client << " client";
  }
};

constexpr double kSoon = 30.0;  // s; a limit for a stuck test, never a measure
constexpr std::uint32_t kDomain = 21;

class Failover : public testing::TestWithParam<Fleet> {
 protected:
  static DaemonOptions options(const char* name, const char* vendor) {
    return {.name = name,
            .vendor = vendor,
            .domain = kDomain,
            .robots = {good_robot("good", 2)},
            .more = "metrics: {enabled: false}\n"};
  }

  void SetUp() override {
    ASSERT_TRUE(eventually([&] { return client_.servers().size() == 2 && client_.robots().size() == 2; }));
    for (const auto& server : client_.servers()) ASSERT_TRUE(client_.wait_for_server(kSoon, server.info.key()));
    for (const auto& server : client_.servers())
      if (server.info.name() == "one") first_ = server.info.key();
  }

  // The daemon that has the plan.
  Daemon& its(const client::Plan& plan) { return plan.server() == first_ ? one_ : two_; }

  static void expect_whole(const client::Plan& plan, std::uint32_t steps) {
    const auto record = plan.record();
    ASSERT_EQ(record.steps.size(), steps);
    for (std::uint32_t i = 0; i < steps; ++i) ASSERT_EQ(record.steps[i].index(), i);
  }

  // What each server answers about a request.
  std::map<msg::Id, msg::PlanEvent> answers(const msg::Id& request) {
    Wire wire(GetParam().client, kDomain);
    EXPECT_TRUE(wire.connect("good"));
    std::map<msg::Id, msg::PlanEvent> found;
    EXPECT_TRUE(wire.wait_until(kSoon, [&] {
      wire.query(request, 1000000);
      found.clear();
      for (const auto& event : wire.events(request)) found[event.message.server()] = event.message;
      return found.size() == 2 && std::ranges::all_of(found, [](const auto& e) { return msg::is_final(e.second.state()); });
    }));
    return found;
  }

  Daemon one_{options("one", GetParam().one)};
  Daemon two_{options("two", GetParam().two)};
  client::Client client_{{.vendor = GetParam().client, .domain = kDomain, .network_config = {}}};
  msg::Id first_{};  // the id of one_
};

TEST_P(Failover, AKilledServersPlanIsMadeByTheOtherAndNotAgainByItself) {
  for (const bool resume : {false, true}) {
    SCOPED_TRACE(resume ? "resume" : "no resume");
    msg::PlanRequest request = paced_request("good", 300, 0.01);
    request.resume(resume);
    client::Plan plan = client_.submit(request);
    ASSERT_TRUE(eventually([&] { return plan.steps_ready() >= 20; }));
    const msg::Id lost = plan.server();
    Daemon& daemon = its(plan);
    daemon.kill();
    ASSERT_TRUE(eventually([&] { return plan.traffic().moves == 1; }));
    const std::size_t before = plan.steps_ready();
    daemon.start();  // while the other plans
    const auto end = plan.wait(kSoon);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->state(), msg::SUCCEEDED) << describe(*end);
    EXPECT_NE(end->server(), lost);
    expect_whole(plan, 300);
    EXPECT_GE(before, 20u);

    ASSERT_TRUE(eventually([&] { return std::ranges::all_of(client_.servers(), [](const auto& s) { return s.alive; }); }));
    auto ends = answers(plan.id());
    EXPECT_EQ(ends[end->server()].state(), msg::SUCCEEDED);
    EXPECT_EQ(ends[lost].state(), resume ? msg::CANCELLED : msg::FAILED) << describe(ends[lost]);
    EXPECT_EQ(ends[lost].error().code(), resume ? msg::MOVED : msg::SERVER_RESTARTED) << describe(ends[lost]);
    EXPECT_LT(ends[lost].steps(), 200u) << "it has planned on";
    // Who asks for the id alone gets the plan that counts.
    client::Client later({.vendor = GetParam().client, .domain = kDomain, .network_config = {}});
    ASSERT_TRUE(eventually([&] { return later.servers().size() == 2; }));
    client::Plan asked = later.query(plan.id());
    const auto answer = asked.wait(kSoon);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->state(), msg::SUCCEEDED) << describe(*answer);
    expect_whole(asked, 300);
  }
}

TEST_P(Failover, AHaltedServerIsToldWhenItGoesOn) {
  client::Plan plan = client_.submit(paced_request("good", 300, 0.01));
  ASSERT_TRUE(eventually([&] { return plan.steps_ready() >= 20; }));
  const msg::Id lost = plan.server();
  Daemon& daemon = its(plan);
  daemon.signal(SIGSTOP);
  ASSERT_TRUE(eventually([&] { return plan.traffic().moves == 1; }));
  daemon.signal(SIGCONT);
  const auto end = plan.wait(kSoon);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->state(), msg::SUCCEEDED) << describe(*end);
  EXPECT_NE(end->server(), lost) << "though the first may have ended it as well";
  expect_whole(plan, 300);
  const auto record = plan.record();
  EXPECT_EQ(record.steps.back().server(), end->server());
}

TEST_P(Failover, AServerThatStopsPassesItsPlansOn) {
  client::Plan plan = client_.submit(paced_request("good", 200, 0.01));
  ASSERT_TRUE(eventually([&] { return plan.steps_ready() >= 20; }));
  EXPECT_EQ(its(plan).stop(), 0);
  const auto end = plan.wait(kSoon);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->state(), msg::SUCCEEDED) << describe(*end);
  EXPECT_EQ(plan.traffic().moves, 1u);
  expect_whole(plan, 200);
}

TEST_P(Failover, UnderLoadEveryRequestEnds) {
  std::vector<client::Plan> plans;
  for (int i = 0; i < 60; ++i) plans.push_back(client_.submit(paced_request("good", 10, 0.005)));
  ASSERT_TRUE(eventually([&] { return plans.front().ended(); }));
  its(plans.back()).kill();
  std::size_t moved = 0;
  std::set<msg::Id> servers;
  for (client::Plan& plan : plans) {
    servers.insert(plan.server());
    const auto end = plan.wait(kSoon);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->state(), msg::SUCCEEDED) << describe(*end);
    expect_whole(plan, 10);
    moved += plan.traffic().moves;
  }
  EXPECT_GE(moved, 1u);
  EXPECT_EQ(servers.size(), 2u) << "the load was shared";
}

// P40
TEST_P(Failover, ASceneGoesToAllServersAndAPlanToOneThatHasIt) {
  const std::string yard = "ground: 1\n", garden = "ground: 2\n";
  const auto put = [&](const std::string& name, const std::string& text, const msg::Id& server) {
    const auto verdict = client_.upload(name, "yaml", std::as_bytes(std::span(text)), kSoon, server);
    ASSERT_TRUE(verdict);
    ASSERT_EQ(verdict->state(), msg::STORED) << verdict->error().message();
  };
  put("yard", yard, msg::kNoId);
  put("garden", garden, first_);
  std::map<std::string, std::size_t> holders;
  for (const auto& scene : client_.scenes()) ++holders[scene.name()];
  EXPECT_EQ(holders, (std::map<std::string, std::size_t>{{"garden", 1}, {"yard", 2}}));

  msg::PlanRequest request = paced_request("good", 200, 0.01);
  request.scene("garden");
  client::Plan only_there = client_.submit(request);
  EXPECT_TRUE(eventually([&] { return only_there.steps_ready() > 0; }));
  EXPECT_EQ(only_there.server(), first_);
  request.id(msg::random_id());
  request.scene("yard");
  std::vector<client::Plan> everywhere;
  for (int i = 0; i < 2; ++i) {
    request.id(msg::random_id());
    everywhere.push_back(client_.submit(request));
  }
  for (const auto& plan : everywhere) EXPECT_TRUE(eventually([&] { return plan.steps_ready() > 0; }));
  one_.kill();
  const auto nowhere = only_there.wait(kSoon);
  ASSERT_TRUE(nowhere);
  EXPECT_EQ(nowhere->state(), msg::REJECTED) << describe(*nowhere);
  EXPECT_EQ(nowhere->error().code(), msg::UNKNOWN_SCENE);
  EXPECT_EQ(nowhere->steps(), only_there.record().steps.size()) << "which stay";
  for (const auto& plan : everywhere) {
    const auto end = plan.wait(kSoon);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->state(), msg::SUCCEEDED) << describe(*end);
    expect_whole(plan, 200);
  }
}

// Who stood still himself does not take the servers for silent.
TEST_P(Failover, AHaltedClientStaysWithItsServer) {
  Wire watcher(GetParam().client, kDomain, "*");
  ASSERT_TRUE(watcher.connect("good"));
  const msg::Id id = msg::random_id();
  Child client({FOOTHOLD_LONE_CLIENT, GetParam().client, std::to_string(kDomain), msg::to_hex(id), "good", "700", "0.01"});
  ASSERT_TRUE(watcher.wait_for_steps(id, 20));
  for (int round = 0; round < 3; ++round) {
    client.signal(SIGSTOP);
    std::this_thread::sleep_for(std::chrono::seconds(2));
    client.signal(SIGCONT);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_EQ(client.wait(kSoon), static_cast<int>(msg::SUCCEEDED));
  std::set<msg::Id> planned_by;
  for (const auto& step : watcher.steps(id)) planned_by.insert(step.message.server());
  EXPECT_EQ(planned_by.size(), 1u);
}

// P40: what a client has uploaded goes to servers that come later, too.
TEST_P(Failover, AServerThatCameLaterHasTheSceneWhenItIsNeeded) {
  std::string yard = "ground: 1\n";  // too long for what the bus keeps for late readers
  while (yard.size() < 5000000) yard += "# " + std::string(1000, '.') + "\n";
  EXPECT_EQ(two_.stop(), 0);
  ASSERT_TRUE(eventually([&] { return std::ranges::count_if(client_.servers(), [](const auto& s) { return s.alive; }) == 1; }));
  const auto verdict = client_.upload("yard", "yaml", std::as_bytes(std::span(yard)), kSoon);
  ASSERT_TRUE(verdict);
  ASSERT_EQ(verdict->state(), msg::STORED) << verdict->error().message();
  msg::PlanRequest request = paced_request("good", 300, 0.01);
  request.scene("yard");
  client::Plan plan = client_.submit(request);
  ASSERT_TRUE(eventually([&] { return plan.steps_ready() >= 20; }));
  ASSERT_EQ(plan.server(), first_);
  two_.start();
  ASSERT_TRUE(eventually([&] { return std::ranges::count_if(client_.servers(), [](const auto& s) { return s.alive; }) == 2; }));
  one_.kill();  // before the second can have it
  const auto end = plan.wait(kSoon);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->state(), msg::SUCCEEDED) << describe(*end);
  EXPECT_NE(end->server(), first_);
  EXPECT_EQ(end->summary().scene_revision(), verdict->revision());
  expect_whole(plan, 300);
}

INSTANTIATE_TEST_SUITE_P(Fleets, Failover,
                         testing::Values(Fleet{"cyclone", "cyclone", "cyclone"}, Fleet{"fastdds", "fastdds", "fastdds"},
                                         Fleet{"cyclone", "fastdds", "cyclone"}, Fleet{"cyclone", "fastdds", "fastdds"}),
                         [](const auto& fleet) {
                           return std::string(fleet.param.one) + "_" + fleet.param.two + "_" + fleet.param.client;
                         });

}  // namespace
}  // namespace foothold::test
