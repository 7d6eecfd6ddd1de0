// SIGHUP to the real server: what it takes, what it refuses, and that plans go on meanwhile.
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "daemon.hpp"
#include "eventually.hpp"
#include "http_get.hpp"
#include "notify_socket.hpp"
#include "planners.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(piece, at)) != std::string::npos; at += piece.size()) ++found;
  return found;
}

// Asks for a reload and waits until it is over: taken or refused.
void reload(Daemon& daemon) {
  const auto ends = [&] {
    const std::string log = daemon.log();
    return count(log, "the configuration is taken") + count(log, "is not taken");
  };
  const std::size_t before = ends();
  daemon.hang_up();
  ASSERT_TRUE(eventually([&] { return ends() > before; })) << daemon.log();
}

bool becomes(Wire& wire, const std::string& robot, msg::RobotState state) {
  return wire.wait_until(20.0, [&] {
    const auto info = wire.robot(robot);
    return info && info->state() == state;
  });
}

TEST(Reloading, AFaultyConfigurationIsToldWithEveryFaultAndNothingOfItIsTaken) {
  DaemonOptions options{.domain = 74, .robots = {good_robot("good")}};
  Daemon daemon(options);
  Wire wire("cyclone", options.domain);
  ASSERT_TRUE(wire.connect("good"));
  const auto before = daemon.workers();
  DaemonOptions faulty = options;
  faulty.robots.push_back(good_robot("another"));
  faulty.more = "queue_limit: none\nquene: 3\n";
  daemon.configure(faulty);
  reload(daemon);
  EXPECT_NE(daemon.log().find("queue_limit: must be a whole number (is 'none')"), std::string::npos);
  EXPECT_NE(daemon.log().find("quene: is not known here"), std::string::npos);
  EXPECT_NE(daemon.log().find("the configuration has 2 faults and is not taken; the one of before stays"), std::string::npos);
  EXPECT_EQ(daemon.workers(), before);
  EXPECT_FALSE(wire.robot("another"));
  EXPECT_EQ(wire.final_event(wire.submit(paced_request("good", 3, 0.0)))->message.state(), msg::SUCCEEDED);
  EXPECT_EQ(daemon.stop(), 0);
}

TEST(Reloading, RobotsComeAndGoAndWhatRunsEndsOnTheOlderWorkers) {
  DaemonOptions options{.domain = 75, .robots = {good_robot("stays"), good_robot("changes"), good_robot("goes")}};
  Daemon daemon(options);
  Wire wire("cyclone", options.domain);
  for (const TestRobot& robot : options.robots) ASSERT_TRUE(wire.connect(robot.name));
  const auto before = daemon.workers();
  ASSERT_EQ(before.size(), 3U);
  const msg::Id on_changing = wire.submit(paced_request("changes", 400, 0.002));
  const msg::Id on_going = wire.submit(paced_request("goes", 400, 0.002));
  const msg::Id waits = wire.submit(paced_request("goes", 1, 0.0));
  ASSERT_TRUE(wire.wait_for_steps(on_changing, 5));
  ASSERT_TRUE(wire.wait_for_steps(on_going, 5));

  options.robots = {good_robot("stays"), {.name = "changes", .plugin = "recall"}, good_robot("comes")};
  daemon.configure(options);
  reload(daemon);
  EXPECT_TRUE(becomes(wire, "comes", msg::READY));
  EXPECT_TRUE(becomes(wire, "goes", msg::UNAVAILABLE));
  EXPECT_TRUE(wire.wait_until(20.0, [&] { return wire.robot("changes")->plugin() == "recall"; }));
  EXPECT_NE(daemon.log().find("robot stays: nothing changed, its workers stay"), std::string::npos);
  EXPECT_EQ(wire.final_event(wire.submit(paced_request("comes", 2, 0.0)))->message.state(), msg::SUCCEEDED);
  EXPECT_EQ(wire.final_event(wire.submit(request_for("changes")))->message.summary().plugin(), "recall");
  const auto refused = wire.final_event(wire.submit(request_for("goes")))->message;
  EXPECT_EQ(refused.state(), msg::REJECTED);
  EXPECT_EQ(refused.error().code(), msg::ROBOT_UNAVAILABLE) << describe(refused);
  EXPECT_EQ(wire.final_event(waits)->message.state(), msg::FAILED) << "nobody plans for it any more";

  for (const msg::Id& id : {on_changing, on_going}) {
    const auto end = wire.final_event(id);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
    EXPECT_EQ(end->message.steps(), 400U);
  }
  EXPECT_TRUE(eventually([&] { return daemon.workers().size() == 3U; })) << "those of before leave after their runs";
  EXPECT_EQ(count(daemon.log(), "died"), 0U);

  options.robots = {good_robot("stays"), good_robot("goes")};
  daemon.configure(options);
  reload(daemon);
  EXPECT_TRUE(becomes(wire, "goes", msg::READY)) << "what went may come back";
  EXPECT_EQ(wire.final_event(wire.submit(paced_request("goes", 2, 0.0)))->message.state(), msg::SUCCEEDED);
  EXPECT_EQ(daemon.stop(), 0);
}

TEST(Reloading, LimitsAndFiguresAreTakenAndWhatTakesARestartIsTold) {
  DaemonOptions options{.domain = 76, .robots = {good_robot("good")}, .more = "metrics: {enabled: false}\n"};
  Daemon daemon(options);
  Wire wire("cyclone", options.domain);
  ASSERT_TRUE(wire.connect("good"));
  options.more = "budget_max: 1\nmetrics: {port: 0}\n";
  options.vendor = "fastdds";
  daemon.configure(options);
  reload(daemon);
  EXPECT_NE(daemon.log().find("dds is another now: that takes a restart"), std::string::npos);
  const auto refused = wire.final_event(wire.submit(paced_request("good", 1, 0.0)))->message;
  EXPECT_EQ(refused.state(), msg::REJECTED);
  EXPECT_EQ(refused.error().field(), "budget") << describe(refused);
  const std::string before = "figures: http://127.0.0.1:";
  const std::string log = daemon.log();
  ASSERT_NE(log.find(before), std::string::npos);
  const auto port = static_cast<std::uint16_t>(std::atoi(log.c_str() + log.find(before) + before.size()));
  EXPECT_EQ(sample(http_get(port, "/metrics").body, "foothold_reloads_total"), 1);
  options.more = "metrics: {enabled: false}\n";
  daemon.configure(options);
  reload(daemon);
  EXPECT_EQ(http_get(port, "/metrics").status, 0);
  EXPECT_EQ(daemon.stop(), 0);
}

TEST(Reloading, RequestsAreServedThroughManyReloads) {
  DaemonOptions options{.domain = 77, .robots = {good_robot("good", 2)}};
  Daemon daemon(options);
  Wire wire("cyclone", options.domain);
  ASSERT_TRUE(wire.connect("good"));
  std::vector<msg::Id> ids;
  for (int i = 0; i < 60; ++i) {
    ids.push_back(wire.submit(paced_request("good", 20, 0.001)));
    if (i % 6 != 0) continue;
    options.robots = {good_robot("good", 1 + static_cast<unsigned>(i / 6) % 3)};
    daemon.configure(options);
    daemon.hang_up();
  }
  for (const msg::Id& id : ids) {
    const auto end = wire.final_event(id, 60.0);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
    EXPECT_TRUE(wire.wait_for_steps(id, 20));
  }
  EXPECT_EQ(daemon.stop(), 0);
}

TEST(Reloading, TheSupervisorIsToldAndFedByTheLoopThatDoesTheWork) {
  NotifySocket supervisor;
  Daemon daemon({.domain = 78, .robots = {good_robot("good")}});
  EXPECT_NE(supervisor.next("READY=1").find("STATUS=1 robots"), std::string::npos);
  EXPECT_FALSE(supervisor.next("WATCHDOG=1").empty());
  daemon.hang_up();
  EXPECT_NE(supervisor.next("RELOADING=1").find("\nMONOTONIC_USEC="), std::string::npos);
  EXPECT_FALSE(supervisor.next("READY=1").empty());
  EXPECT_FALSE(supervisor.next("WATCHDOG=1").empty());
  daemon.signal(SIGSTOP);
  while (!supervisor.next("WATCHDOG=1", 0.3).empty()) {
  }
  EXPECT_TRUE(supervisor.next("WATCHDOG=1", 1.0).empty()) << "a process that does nothing must not be fed";
  daemon.signal(SIGCONT);
  EXPECT_FALSE(supervisor.next("WATCHDOG=1").empty());
  daemon.signal(SIGTERM);
  EXPECT_FALSE(supervisor.next("STOPPING=1").empty());
}

}  // namespace
}  // namespace foothold::test
