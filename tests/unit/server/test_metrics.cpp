// Figures: what Jobs shows of requests, how it is counted, and the text that Prometheus reads.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "fakes.hpp"
#include "metrics/server_state.hpp"

namespace foothold::server::testing {
namespace {

// The value of a sample by its whole left side; nothing if it is not there.
std::optional<double> value(const std::string& text, const std::string& sample) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(sample + " ")) return std::stod(line.substr(sample.size() + 1));
  return std::nullopt;
}

TEST(Exposition, EscapesWhatWouldBreakALine) {
  Exposition out;
  out.family("x", Exposition::Kind::kGauge, "a\\b\nc");
  out.sample({{"l", "q\"b\\n\ne"}}, std::uint64_t{7});
  EXPECT_EQ(out.text(), "# HELP x a\\\\b\\nc\n# TYPE x gauge\nx{l=\"q\\\"b\\\\n\\ne\"} 7\n");
}

TEST(Exposition, BucketsOfAHistogramAddUp) {
  Histogram histogram;
  for (const double seconds : {0.0, 1e-4, 1.1e-4, 0.5, 60.0, 61.0}) histogram.add(seconds);
  Exposition out;
  out.family("h", Exposition::Kind::kHistogram, "");
  out.sample({{"robot", "r"}}, histogram);
  EXPECT_EQ(value(out.text(), "h_bucket{robot=\"r\",le=\"0.0001\"}"), 2);
  EXPECT_EQ(value(out.text(), "h_bucket{robot=\"r\",le=\"0.00025\"}"), 3);
  EXPECT_EQ(value(out.text(), "h_bucket{robot=\"r\",le=\"0.5\"}"), 4);
  EXPECT_EQ(value(out.text(), "h_bucket{robot=\"r\",le=\"60\"}"), 5);
  EXPECT_EQ(value(out.text(), "h_bucket{robot=\"r\",le=\"+Inf\"}"), 6);
  EXPECT_EQ(value(out.text(), "h_count{robot=\"r\"}"), 6);
  EXPECT_NEAR(*value(out.text(), "h_sum{robot=\"r\"}"), 121.50021, 1e-6);
}

// Every line is a comment or "name{labels} value", each family is introduced once and its samples stand together.
TEST(Exposition, TheWholeTextIsWellFormed) {
  ServerState server;
  server.name = "yard \"1\"";
  server.robots = {{.name = "a", .state = "READY"}, {.name = "b", .state = "QUARANTINED", .reason = "it crashed"}};
  server.topics = {{"foothold/request", false, 2, 1}, {"foothold/event", true, 3, 0}};
  RequestFigures requests;
  requests.set_robots({"a", "b"});
  const std::regex sample(R"re(([a-z_]+)(\{([a-z]+="([^"\\\n]|\\.)*",?)+\})? (\+Inf|-Inf|NaN|-?[0-9.e+-]+))re");
  std::istringstream lines(prometheus_text(server, requests));
  std::set<std::string> families;
  std::string family;
  std::smatch part;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# HELP ")) {
      family = line.substr(7, line.find(' ', 7) - 7);
      EXPECT_TRUE(families.insert(family).second) << line;
    } else if (!line.starts_with("# TYPE " + family + " ")) {
      ASSERT_TRUE(std::regex_match(line, part, sample)) << line;
      const std::string name = part[1];
      EXPECT_TRUE(name == family || name == family + "_bucket" || name == family + "_sum" || name == family + "_count") << line;
    }
  }
  EXPECT_GT(families.size(), 25U);
}

class Counting : public ::testing::Test {
 protected:
  Counting() {
    figures_.set_robots({"walker", "climber"});
    world_.watches = {&figures_};
    world_.restart();
  }
  std::optional<double> figure(const std::string& sample) const {
    Exposition out;
    figures_.write(out);
    return value(out.text(), sample);
  }
  std::optional<double> ended(const std::string& state, const std::string& robot = "walker") const {
    return figure("foothold_requests_total{robot=\"" + robot + "\",state=\"" + state + "\"}");
  }
  World world_;
  RequestFigures figures_;
};

TEST(Exposition, TellsWhetherSecurityIsOnAndWhenTheCredentialsEnd) {
  ServerState state;
  EXPECT_NE(prometheus_text(state, RequestFigures()).find("\nfoothold_dds_security 0\n"), std::string::npos);
  EXPECT_EQ(prometheus_text(state, RequestFigures()).find("foothold_credentials_expire"), std::string::npos);
  state.credentials_expire = 1800000000;
  EXPECT_NE(prometheus_text(state, RequestFigures()).find("\nfoothold_dds_security 1\n"), std::string::npos);
  EXPECT_NE(prometheus_text(state, RequestFigures()).find("\nfoothold_credentials_expire_timestamp_seconds 1800000000\n"),
            std::string::npos);
}

TEST_F(Counting, EveryFinalStateIsCountedOnceUnderItsRobot) {
  const auto request = [&](const std::string& name) {
    world_.submit(good_request(name));
    return good_request(name).id();
  };
  world_.end(request("a"), msg::SUCCEEDED);
  world_.end(request("b"), msg::PARTIAL);
  world_.end(request("c"), msg::FAILED, msg::NO_PATH);
  world_.lose(request("d"), msg::WORKER_CRASHED);
  const Id cancelled = request("e");
  world_.cancel(cancelled);
  world_.end(cancelled, msg::CANCELLED);
  const Id expired = request("f");
  world_.wait(10.0);
  world_.end(expired, msg::CANCELLED);
  auto faulty = good_request("g");
  faulty.budget(-1);
  world_.submit(faulty);
  for (const char* state : {"SUCCEEDED", "PARTIAL", "FAILED", "CRASHED", "CANCELLED", "EXPIRED", "REJECTED"})
    EXPECT_EQ(ended(state), 1) << state;
  EXPECT_EQ(ended("SUCCEEDED", "climber"), 0);
  world_.submit(good_request("a"));
  world_.query(good_request("b").id());
  world_.cancel(cancelled);
  EXPECT_EQ(ended("SUCCEEDED"), 1) << "an answer is no end";
  EXPECT_EQ(ended("CANCELLED"), 1);
}

TEST_F(Counting, ARobotThatIsNotKnownMakesNoLabel) {
  for (int i = 0; i < 100; ++i) {
    auto request = good_request(std::to_string(i));
    request.robot("robot " + std::to_string(i));
    world_.submit(request);
  }
  EXPECT_EQ(ended("REJECTED", ""), 100);
  EXPECT_EQ(ended("REJECTED", "robot 1"), std::nullopt);
}

TEST_F(Counting, WaitingPlanningAndStepsAreMeasuredApart) {
  std::vector<Id> ids;
  for (const char* name : {"first", "second", "waits"}) {
    world_.submit(good_request(name));
    ids.push_back(good_request(name).id());
  }
  world_.wait(2.0);
  world_.step(ids[0], 0);
  world_.wait(0.5);
  world_.step(ids[0], 1);
  world_.end(ids[0], msg::SUCCEEDED);  // after 2.5 s; the third starts
  world_.wait(1.0);
  world_.step(ids[2], 0);
  world_.end(ids[2], msg::SUCCEEDED);
  const std::string robot = "{robot=\"walker\"}";
  EXPECT_EQ(figure("foothold_steps_total" + robot), 3);
  EXPECT_NEAR(*figure("foothold_wait_seconds_sum" + robot), 2.5, 1e-6);
  EXPECT_NEAR(*figure("foothold_plan_seconds_sum" + robot), 3.5, 1e-6);
  EXPECT_NEAR(*figure("foothold_step_seconds_sum" + robot), 2.0 + 0.5 + 1.0, 1e-6);
  EXPECT_NEAR(*figure("foothold_first_step_seconds_sum" + robot), 2.0 + 3.5, 1e-6);
  EXPECT_EQ(figure("foothold_plan_seconds_count" + robot), 2);
}

TEST_F(Counting, WhatExpiresInTheQueueHasWaitedAndNotPlanned) {
  for (const char* name : {"a", "b", "waits"}) world_.submit(good_request(name));
  world_.wait(10.0);
  EXPECT_EQ(ended("EXPIRED"), 1);
  EXPECT_NEAR(*figure("foothold_wait_seconds_sum{robot=\"walker\"}"), 10.0, 1e-6);
  EXPECT_EQ(figure("foothold_plan_seconds_count{robot=\"walker\"}"), 0);
}

TEST_F(Counting, AnEndThatCannotBeStoredIsCountedAsItWasTold) {
  world_.submit(good_request("a"));
  world_.journal.full = true;
  world_.end(good_request("a").id(), msg::SUCCEEDED);
  EXPECT_EQ(world_.state(good_request("a").id()), msg::FAILED);
  EXPECT_EQ(ended("FAILED"), 1);
  EXPECT_EQ(ended("SUCCEEDED"), 0);
}

TEST_F(Counting, WhatARestartEndsIsCountedAndHasNotPlanned) {
  world_.submit(good_request("a"));
  world_.restart();
  EXPECT_EQ(ended("FAILED"), 1);
  EXPECT_EQ(figure("foothold_plan_seconds_count{robot=\"walker\"}"), 0);
}

ServerState serving() {
  ServerState server;
  server.serving = true;
  server.robots = {{.name = "a", .state = "READY"}, {.name = "b", .state = "QUARANTINED", .reason = "it crashed"}};
  return server;
}

TEST(HealthOfAServer, IsWellWhileItCanPlanAndStore) {
  const HealthReport report = health_of(serving());
  EXPECT_TRUE(report.well);
  EXPECT_EQ(report.text, "ok\njournal: ok\nrobot a: READY\nrobot b: QUARANTINED: it crashed\n");
}

TEST(HealthOfAServer, SaysWhatIsWrong) {
  const auto fault = [](auto&& spoil) {
    ServerState server = serving();
    spoil(server);
    const HealthReport report = health_of(server);
    EXPECT_FALSE(report.well);
    return report.text.substr(0, report.text.find('\n'));
  };
  EXPECT_EQ(fault([](ServerState& s) { s.serving = false; }), "starting: planners are being loaded");
  EXPECT_EQ(fault([](ServerState& s) { s.stopping = true; }), "stopping");
  EXPECT_EQ(fault([](ServerState& s) { s.journal_trouble = "the disk is full"; }), "the journal cannot be written");
  EXPECT_EQ(fault([](ServerState& s) { s.robots[0].state = "UNAVAILABLE"; }), "no robot is ready");
}

}  // namespace
}  // namespace foothold::server::testing
