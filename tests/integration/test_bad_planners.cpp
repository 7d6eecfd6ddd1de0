// What a bad planner does to its own request, and does not do to anybody else's: P6, P10, P19, P20.
#include <cstdio>
#include <span>

#include "daemon.hpp"
#include "foothold/export.hpp"
#include "planners.hpp"
#include "vendor_pairs.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

constexpr double kGrace = 0.25;
// Starting and killing processes on a machine that builds something else at the same time.
constexpr double kSlack = 1.5;

struct BadPlanner {
  const char* robot;
  msg::State state;
  std::uint16_t code;
  double budget;    // s
  bool to_the_end;  // it takes the whole budget
};

constexpr std::array kBadPlanners{
    BadPlanner{"crash", msg::CRASHED, msg::WORKER_CRASHED, 10.0, false},
    BadPlanner{"hang", msg::EXPIRED, msg::BUDGET_EXHAUSTED, 0.5, true},
    BadPlanner{"ignore", msg::EXPIRED, msg::BUDGET_EXHAUSTED, 0.5, true},
    BadPlanner{"memory", msg::CRASHED, msg::OUT_OF_MEMORY, 10.0, false},
    BadPlanner{"throw", msg::FAILED, msg::PLUGIN_THREW, 10.0, false},
    BadPlanner{"refused", msg::FAILED, msg::STEP_REFUSED, 10.0, false},
};

// A daemon with a good robot and the bad one, and two clients. Each request to the bad one is asked while the good one plans.
void expect_isolation(const VendorPair& pair, std::span<const BadPlanner> planners) {
  DaemonOptions options{.vendor = pair.server, .domain = 11, .robots = {good_robot("good")}, .grace = kGrace};
  for (const BadPlanner& bad : planners) options.robots.push_back(bad_robot(bad.robot));
  Daemon daemon(options);
  Wire wire(pair.client, options.domain);
  ASSERT_TRUE(wire.connect("good"));
  for (const BadPlanner& bad : planners) ASSERT_TRUE(wire.connect(bad.robot)) << bad.robot;
  const pid_t pid = daemon.pid();

  for (const BadPlanner& bad : planners) {
    SCOPED_TRACE(bad.robot);
    constexpr std::uint32_t kSteps = 200;
    const msg::Id undisturbed = wire.submit(paced_request("good", kSteps, 0.01));
    ASSERT_TRUE(wire.wait_for_steps(undisturbed, 5));

    const auto asked = SteadyClock::now();
    const msg::Id id = wire.submit(request_for(bad.robot, bad.budget));
    const auto end = wire.final_event(id);
    ASSERT_TRUE(end);
    const double took = std::chrono::duration<double>(end->at - asked).count();
    std::printf("%-8s ended after %.0f ms: %s\n", bad.robot, took * 1e3, describe(end->message).c_str());
    EXPECT_EQ(end->message.state(), bad.state) << describe(end->message);
    EXPECT_EQ(end->message.error().code(), bad.code) << describe(end->message);
    EXPECT_FALSE(end->message.error().message().empty());
    EXPECT_LE(took, (bad.to_the_end ? bad.budget + kGrace : 0.0) + kSlack);
    EXPECT_GE(took, bad.to_the_end ? bad.budget * 0.99 : 0.0);
    ASSERT_TRUE(wire.wait_for_steps(id, end->message.steps()));
    EXPECT_EQ(wire.steps(id).size(), end->message.steps());

    const auto other = wire.final_event(undisturbed);
    ASSERT_TRUE(other);
    EXPECT_EQ(other->message.state(), msg::SUCCEEDED) << describe(other->message);
    EXPECT_GT(other->at, end->at) << "the good robot's plan was over before: this test shows nothing";
    ASSERT_TRUE(wire.wait_for_steps(undisturbed, kSteps));
    const auto steps = wire.steps(undisturbed);
    ASSERT_EQ(steps.size(), kSteps);
    for (std::uint32_t i = 0; i < kSteps; ++i) EXPECT_EQ(steps[i].message.index(), i);
  }
  EXPECT_TRUE(daemon.running());
  EXPECT_EQ(daemon.pid(), pid);
  EXPECT_EQ(daemon.stop(), 0);
}

void PrintTo(const BadPlanner& bad, std::ostream* out) { *out << bad.robot; }

class BadPlanners : public testing::TestWithParam<BadPlanner> {};

TEST_P(BadPlanners, EndItsOwnRequestAndNoOther) { expect_isolation(kVendorPairs[0], {&GetParam(), 1}); }

INSTANTIATE_TEST_SUITE_P(Each, BadPlanners, testing::ValuesIn(kBadPlanners),
                         [](const auto& each) { return std::string(each.param.robot); });

TEST(UnlikePlanner, BuiltForAnotherApiIsUnavailableAndSaysBothVersions) {
  const DaemonOptions options{.domain = 11, .robots = {good_robot("good"), bad_robot("unlike_api")}};
  Daemon daemon(options);
  Wire wire(options.vendor, options.domain);
  ASSERT_TRUE(wire.connect("good"));
  ASSERT_TRUE(wire.wait_until(10.0, [&] { return wire.robot("unlike_api").has_value(); }));
  EXPECT_EQ(wire.robot("unlike_api")->state(), msg::UNAVAILABLE);
  const msg::Id id = wire.submit(request_for("unlike_api"));
  const auto end = wire.final_event(id);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->message.state(), msg::REJECTED) << describe(end->message);
  EXPECT_EQ(end->message.error().code(), msg::ROBOT_UNAVAILABLE) << describe(end->message);
  const std::string both = "version " + std::to_string(2 * kApiVersion) + ", this server has " + std::to_string(kApiVersion);
  EXPECT_NE(end->message.error().message().find(both), std::string::npos) << describe(end->message);
  const auto other = wire.final_event(wire.submit(paced_request("good", 5, 0.0)));
  ASSERT_TRUE(other);
  EXPECT_EQ(other->message.state(), msg::SUCCEEDED);
}

class BadPlannersOfPair : public testing::TestWithParam<VendorPair> {};

TEST_P(BadPlannersOfPair, EndTheirOwnRequestsAndNoOther) { expect_isolation(GetParam(), kBadPlanners); }

INSTANTIATE_TEST_SUITE_P(Other, BadPlannersOfPair, testing::ValuesIn(kVendorPairs.begin() + 1, kVendorPairs.end()), pair_name);

}  // namespace
}  // namespace foothold::test
