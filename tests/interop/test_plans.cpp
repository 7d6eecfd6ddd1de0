// 200 plans of 100 steps each at the same time, through the real server and its workers, for every vendor pair: P3, P14, P15, P17.
#include <gtest/gtest.h>

#include <algorithm>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <vector>

#include "daemon.hpp"
#include "foothold/client/client.hpp"
#include "planners.hpp"
#include "vendor_pairs.hpp"

namespace foothold::test {
namespace {

constexpr std::size_t kPlans = 200;
constexpr std::uint32_t kSteps = 100;

// What a client of the library was told of one plan.
struct Told {
  std::vector<msg::Step> steps;
  std::vector<msg::State> states;
};

// The step that the test planner `many` emits (tests/plugins/walker.hpp), written down once more.
void expect_emitted(const msg::Step& step, const msg::Id& request, std::uint32_t index) {
  EXPECT_EQ(step.request(), request);
  EXPECT_EQ(step.index(), index);
  EXPECT_EQ(step.label(), "step " + std::to_string(index));
  const double x = 0.1 * (index + 1);
  EXPECT_EQ(step.base().position().x(), x);
  EXPECT_EQ(step.base().orientation().w(), 1.0);
  ASSERT_EQ(step.stance().size(), 2u);
  EXPECT_EQ(step.stance()[0].limb(), "left");
  EXPECT_EQ(step.stance()[1].limb(), "right");
  ASSERT_EQ(step.placed().size(), 1u);
  EXPECT_EQ(step.placed()[0].limb(), index % 2 == 0 ? "left" : "right");
  EXPECT_EQ(step.placed()[0].frame().position().x(), x);
  ASSERT_EQ(step.margins().size(), 1u);
  EXPECT_EQ(step.margins()[0].name(), "advance");
  EXPECT_NEAR(step.margins()[0].value(), 0.1, 1e-9);
  EXPECT_EQ(step.cost(), index + 1.0);
  EXPECT_TRUE(step.shapes().empty());
}

class Plans : public testing::TestWithParam<VendorPair> {};

TEST_P(Plans, TwoHundredAtOnceArriveWholeInOrderAndEndOnce) {
  const DaemonOptions options{.vendor = GetParam().server, .domain = 16, .robots = {good_robot("good", 4)}};
  Daemon daemon(options);
  client::Client client({.vendor = GetParam().client, .domain = options.domain, .network_config = {}});
  ASSERT_TRUE(client.wait_for_robot("good", 20.0));
  ASSERT_TRUE(client.wait_for_server(20.0));

  std::vector<Told> told(kPlans);
  std::atomic<std::size_t> ended = 0;  // callbacks run on the client's own thread: after the last one was told, all are
  std::vector<client::Plan> plans;
  const auto begin = std::chrono::steady_clock::now();
  for (Told& each : told) {
    plans.push_back(
        client.submit(paced_request("good", kSteps, 0.0), {.on_step = [&](const msg::Step& step) { each.steps.push_back(step); },
                                                           .on_event =
                                                               [&](const msg::PlanEvent& event) {
                                                                 each.states.push_back(event.state());
                                                                 if (is_final(event.state())) ++ended;
                                                               },
                                                           .on_server = {}}));
  }
  std::size_t asked_again = 0;
  for (const client::Plan& plan : plans) {
    const auto end = plan.wait(60.0);
    ASSERT_TRUE(end) << "no end of plan " << msg::to_hex(plan.id()) << " with " << plan.steps_ready() << " steps";
    EXPECT_EQ(end->state(), msg::SUCCEEDED) << describe(*end);
    EXPECT_EQ(end->steps(), kSteps);
    asked_again += plan.traffic().queries;
  }
  std::printf("%zu plans of %u steps in %.2f s, %zu queries\n", kPlans, kSteps,
              std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), asked_again);
  const auto until = begin + std::chrono::seconds(60);
  while (ended < kPlans && std::chrono::steady_clock::now() < until) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ASSERT_GE(ended, kPlans);

  for (std::size_t i = 0; i < kPlans; ++i) {
    SCOPED_TRACE("plan " + std::to_string(i));
    EXPECT_EQ(std::ranges::count_if(told[i].states, is_final), 1);
    ASSERT_EQ(told[i].steps.size(), kSteps);
    for (std::uint32_t index = 0; index < kSteps; ++index) expect_emitted(told[i].steps[index], plans[i].id(), index);
  }
  EXPECT_EQ(daemon.stop(), 0);
}

INSTANTIATE_TEST_SUITE_P(Pairs, Plans, testing::ValuesIn(kVendorPairs), pair_name);

}  // namespace
}  // namespace foothold::test
