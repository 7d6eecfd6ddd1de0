// The real server seen from outside: figures and health over HTTP.
#include <gtest/gtest.h>

#include "daemon.hpp"
#include "eventually.hpp"
#include "http_get.hpp"
#include "journal_socket.hpp"
#include "planners.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

// Of the latest start, from its log.
std::uint16_t metrics_port(const Daemon& daemon) {
  const std::string before = "figures: http://127.0.0.1:";
  std::string log;
  eventually([&] { return (log = daemon.log()).find(before) != std::string::npos; });
  const auto at = log.rfind(before);
  return at == std::string::npos ? 0 : static_cast<std::uint16_t>(std::atoi(log.c_str() + at + before.size()));
}

TEST(Watching, FiguresFollowWhatRequestsAndWorkersDo) {
  const DaemonOptions options{.domain = 71,
                              .robots = {good_robot("good"), bad_robot("crash")},
                              .more = std::string("metrics: {port: 0}\n") + kNeverQuarantine};
  Daemon daemon(options);
  Wire wire("cyclone", options.domain);
  ASSERT_TRUE(wire.connect("good"));
  ASSERT_TRUE(wire.connect("crash"));
  const std::uint16_t port = metrics_port(daemon);
  const auto figure = [&](const std::string& name) { return sample(http_get(port, "/metrics").body, name); };
  const auto becomes = [&](const std::string& name, double value) {
    const bool did = eventually([&] { return figure(name) == value; });
    EXPECT_TRUE(did) << name << " is " << figure(name) << ", not " << value;
  };

  const Page health = http_get(port, "/healthz");
  EXPECT_EQ(health.status, 200) << health.body;
  EXPECT_EQ(health.body, "ok\njournal: ok\nrobot crash: READY\nrobot good: READY\n");
  EXPECT_EQ(http_get(port, "/etc/passwd").status, 404);

  const msg::Id done = wire.submit(paced_request("good", 3, 0.0));
  ASSERT_TRUE(wire.final_event(done));
  const msg::Id crashed = wire.submit(request_for("crash"));
  ASSERT_TRUE(wire.final_event(crashed));
  becomes("foothold_requests_total{robot=\"good\",state=\"SUCCEEDED\"}", 1);
  becomes("foothold_requests_total{robot=\"crash\",state=\"CRASHED\"}", 1);
  becomes("foothold_steps_total{robot=\"good\"}", 3);
  becomes("foothold_step_seconds_count{robot=\"good\"}", 3);
  becomes("foothold_plan_seconds_count{robot=\"good\"}", 1);
  becomes("foothold_worker_crashes_total{robot=\"crash\"}", 1);
  becomes("foothold_worker_restarts_total{robot=\"crash\"}", 1);
  becomes("foothold_worker_restarts_total{robot=\"good\"}", 0);
  becomes("foothold_dds_matches{topic=\"foothold/request\",server=\"reads\"}", 1);
  becomes("foothold_dds_matches{topic=\"foothold/event\",server=\"writes\"}", 1);
  becomes("foothold_client_partitions", 1);
  EXPECT_GT(figure("process_resident_memory_bytes"), 1e6);
  EXPECT_GT(figure("foothold_worker_resident_memory_bytes{robot=\"good\"}"), 1e6);

  const msg::Id runs = wire.submit(paced_request("good", 100000, 0.002));
  const msg::Id waits = wire.submit(paced_request("good", 1, 0.0));
  becomes("foothold_running", 1);
  becomes("foothold_queue_length", 1);
  becomes("foothold_workers_busy{robot=\"good\"}", 1);
  wire.cancel(runs);
  ASSERT_TRUE(wire.final_event(waits));
  becomes("foothold_queue_length", 0);
  becomes("foothold_requests_total{robot=\"good\",state=\"CANCELLED\"}", 1);
  EXPECT_EQ(daemon.stop(), 0);
}

TEST(Watching, AnAddressThatIsTakenIsToldAndTheServerServesWithoutFigures) {
  Daemon first({.domain = 72, .robots = {good_robot("good")}, .more = "metrics: {port: 0}\n"});
  const std::uint16_t port = metrics_port(first);
  ASSERT_NE(port, 0);
  Daemon second({.domain = 73, .robots = {good_robot("good")}, .more = "metrics: {port: " + std::to_string(port) + "}\n"});
  Wire wire("cyclone", 73);
  ASSERT_TRUE(wire.connect("good"));
  EXPECT_NE(second.log().find("no figures over HTTP: 127.0.0.1:" + std::to_string(port) + ": Address already in use"),
            std::string::npos);
  EXPECT_EQ(second.stop(), 0);
  EXPECT_EQ(first.stop(), 0);
}

TEST(Watching, EachEndStandsInTheLogWithItsFields) {
  Daemon daemon({.domain = 80, .robots = {good_robot("good"), bad_robot("crash")}});
  Wire wire("cyclone", 80);
  ASSERT_TRUE(wire.connect("good"));
  ASSERT_TRUE(wire.connect("crash"));
  auto request = paced_request("good", 3, 0.0);
  request.unit("yard 3");
  const msg::Id done = wire.submit(request), crashed = wire.submit(request_for("crash"));
  ASSERT_TRUE(wire.final_event(done));
  ASSERT_TRUE(wire.final_event(crashed));
  EXPECT_EQ(daemon.stop(), 0);
  const std::string log = daemon.log(), client = msg::to_hex(wire.id());
  EXPECT_NE(log.find(" info request ended SUCCEEDED request=" + msg::to_hex(done) + " robot=good unit=\"yard 3\" client=" + client +
                     " state=SUCCEEDED steps=3 waited="),
            std::string::npos);
  EXPECT_NE(log.find(" warning request ended CRASHED request=" + msg::to_hex(crashed) + " robot=crash client=" + client +
                     " state=CRASHED error=WORKER_CRASHED "),
            std::string::npos);
}

TEST(Watching, UnderSystemdTheJournalGetsTheFields) {
  JournalSocket journal;
  if (!journal.is_there()) GTEST_SKIP() << "SKIPPED: no mount namespace here, which takes root";
  Daemon daemon({.domain = 81, .robots = {good_robot("good")}});
  {
    Wire wire("cyclone", 81);
    ASSERT_TRUE(wire.connect("good"));
  }
  EXPECT_EQ(daemon.stop(), 0);
  struct stat log {};
  ASSERT_EQ(::stat((daemon.state_folder() + "/../log").c_str(), &log), 0);
  ::setenv("JOURNAL_STREAM", (std::to_string(log.st_dev) + ":" + std::to_string(log.st_ino)).c_str(), 1);
  daemon.start();
  ::unsetenv("JOURNAL_STREAM");
  Wire wire("cyclone", 81);
  ASSERT_TRUE(wire.connect("good"));
  EXPECT_NE(journal.next("FOOTHOLD_ROBOT=good").find("\nPRIORITY=6\nSYSLOG_IDENTIFIER=footholdd\n"), std::string::npos);
  const msg::Id id = wire.submit(paced_request("good", 3, 0.0));
  const std::string entry = journal.next("FOOTHOLD_REQUEST=" + msg::to_hex(id));
  EXPECT_NE(entry.find("\nMESSAGE=request ended SUCCEEDED\n"), std::string::npos) << entry;
  EXPECT_NE(entry.find("\nFOOTHOLD_ROBOT=good\n"), std::string::npos) << entry;
  EXPECT_NE(entry.find("\nFOOTHOLD_STATE=SUCCEEDED\n"), std::string::npos) << entry;
  EXPECT_EQ(daemon.stop(), 0);
}

}  // namespace
}  // namespace foothold::test
