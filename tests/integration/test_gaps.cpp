// Who was not there, who asks for a part, who only watches: P13, P14, P17, P18, P24, and the partition `*`.
#include <algorithm>

#include "daemon.hpp"
#include "planners.hpp"
#include "vendor_pairs.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

class Gaps : public testing::TestWithParam<VendorPair> {
 protected:
  void SetUp() override { ASSERT_TRUE(wire_.connect("good")); }

  DaemonOptions options_{.vendor = GetParam().server, .domain = 14, .robots = {good_robot("good")}};
  Daemon daemon_{options_};
  Wire wire_{GetParam().client, options_.domain};
};

std::vector<std::uint32_t> sorted_indices(const std::vector<Arrival<msg::Step>>& steps) {
  std::vector<std::uint32_t> indices;
  for (const auto& step : steps) indices.push_back(step.message.index());
  std::ranges::sort(indices);
  return indices;
}

TEST_P(Gaps, AForeignClientAsksFromAStepOnAndGetsExactlyThose) {
  const msg::Id id = wire_.submit(paced_request("good", 50, 0.0));
  ASSERT_TRUE(wire_.final_event(id));
  ASSERT_TRUE(wire_.wait_for_steps(id, 50));

  Wire foreign(GetParam().client, options_.domain);
  ASSERT_TRUE(foreign.connect("good"));
  foreign.query(id, 47);
  const auto answer = foreign.final_event(id);
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->message.answer());
  EXPECT_EQ(answer->message.steps(), 50u);
  ASSERT_TRUE(foreign.wait_until(10.0, [&] { return foreign.steps(id).size() >= 3; }));
  // A step too many would have come with them: a second answer shows that the first is over.
  foreign.query(id, 50);
  ASSERT_TRUE(foreign.wait_until(10.0, [&] { return foreign.events(id).size() == 2; }));
  EXPECT_EQ(sorted_indices(foreign.steps(id)), (std::vector<std::uint32_t>{47, 48, 49}));
  EXPECT_EQ(wire_.steps(id).size(), 50u) << "the request's own client was sent what another asked for";
}

// P17: whoever asks again and again for what is under way to him already is not sent it again and again.
TEST_P(Gaps, QuestionsWhileTheAnswerIsUnderWayRepeatNothing) {
  constexpr std::uint32_t kSteps = 6000;
  const msg::Id id = wire_.submit(paced_request("good", kSteps, 0.0));
  ASSERT_TRUE(wire_.final_event(id));
  ASSERT_TRUE(wire_.wait_for_steps(id, kSteps));
  Wire hasty(GetParam().client, options_.domain);
  ASSERT_TRUE(hasty.connect("good"));
  for (int i = 0; i < 20; ++i) hasty.query(id);
  ASSERT_TRUE(hasty.wait_until(10.0, [&] { return hasty.events(id).size() == 20; }));
  ASSERT_TRUE(hasty.wait_for_steps(id, kSteps));
  // A step too many would have come before the step of another plan.
  const msg::Id last = hasty.submit(paced_request("good", 1, 0.0));
  ASSERT_TRUE(hasty.wait_for_steps(last, 1));
  // All of it twice at the most: some of the questions may have come when the answer to the first was over.
  EXPECT_LE(hasty.steps(id).size(), 2 * kSteps);
}

TEST_P(Gaps, AClientThatAsksInMidPlanGetsTheRestAsItComes) {
  const msg::Id id = wire_.submit(paced_request("good", 150, 0.01));
  ASSERT_TRUE(wire_.wait_for_steps(id, 30));
  Wire foreign(GetParam().client, options_.domain);
  ASSERT_TRUE(foreign.connect("good"));
  foreign.query(id, 10);
  ASSERT_TRUE(foreign.wait_until(10.0, [&] { return !foreign.events(id).empty(); }));
  const msg::PlanEvent now = foreign.events(id).front().message;
  EXPECT_EQ(now.state(), msg::RUNNING) << describe(now);
  EXPECT_TRUE(now.answer());
  EXPECT_GE(now.steps(), 30u);
  ASSERT_TRUE(foreign.wait_until(10.0, [&] { return foreign.steps(id).size() >= now.steps() - 10; }));
  // An answer is about the moment; changes of state go to the request's own client alone (P13).
  ASSERT_TRUE(wire_.final_event(id));
  ASSERT_TRUE(wire_.wait_for_steps(id, 150));
  EXPECT_EQ(foreign.events(id).size(), 1u);
  EXPECT_EQ(foreign.steps(id).size(), now.steps() - 10);
}

TEST_P(Gaps, AClientThatComesBackUnderItsIdFindsItsPlan) {
  msg::Id id{};
  const msg::Id name = msg::random_id();
  {
    Wire first(GetParam().client, options_.domain, {}, name);
    ASSERT_TRUE(first.connect("good"));
    id = first.submit(paced_request("good", 100, 0.005));
    ASSERT_TRUE(first.wait_for_steps(id, 10));
  }
  Wire second(GetParam().client, options_.domain, {}, name);
  ASSERT_TRUE(second.connect("good"));
  second.query(id);
  const auto end = second.final_event(id);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->message.state(), msg::SUCCEEDED);
  EXPECT_TRUE(second.wait_for_steps(id, 100));
}

TEST_P(Gaps, TheSameRequestTwiceIsAnsweredAndPlannedOnce) {
  const msg::PlanRequest request = paced_request("good", 20, 0.0);
  wire_.submit(request);
  const auto end = wire_.final_event(request.id());
  ASSERT_TRUE(end);
  ASSERT_TRUE(wire_.wait_for_steps(request.id(), 20));
  Wire other(GetParam().client, options_.domain);
  ASSERT_TRUE(other.connect("good"));
  other.submit(request);
  const auto answer = other.final_event(request.id());
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->message.answer());
  EXPECT_EQ(answer->message.stamp(), end->message.stamp());
  EXPECT_TRUE(other.wait_for_steps(request.id(), 20));
}

TEST_P(Gaps, AnObserverSeesEveryPlanOfEveryClient) {
  Wire second(GetParam().client, options_.domain);
  Wire observer(GetParam().client, options_.domain, "*");
  ASSERT_TRUE(second.connect("good"));
  ASSERT_TRUE(observer.connect("good"));
  const msg::Id a = wire_.submit(paced_request("good", 20, 0.0));
  const msg::Id b = second.submit(paced_request("good", 30, 0.0));
  for (Wire* client : {&wire_, &second}) ASSERT_TRUE(client->final_event(client == &wire_ ? a : b));
  ASSERT_TRUE(observer.final_event(a));
  ASSERT_TRUE(observer.final_event(b));
  EXPECT_TRUE(observer.wait_for_steps(a, 20));
  EXPECT_TRUE(observer.wait_for_steps(b, 30));
  EXPECT_TRUE(wire_.steps(b).empty() && second.steps(a).empty()) << "a client was sent another's plan";
}

TEST_P(Gaps, AQueryOfAnUnknownIdIsAnsweredUnknown) {
  const msg::Id id = msg::random_id();
  wire_.query(id);
  ASSERT_TRUE(wire_.wait_until(10.0, [&] { return !wire_.events(id).empty(); }));
  const msg::PlanEvent answer = wire_.events(id).front().message;
  EXPECT_EQ(answer.state(), msg::UNKNOWN);
  EXPECT_EQ(answer.error().code(), msg::UNKNOWN_REQUEST);
}

INSTANTIATE_TEST_SUITE_P(Pairs, Gaps, testing::ValuesIn(kVendorPairs), pair_name);

}  // namespace
}  // namespace foothold::test
