// The rules of idl/PROTOCOL.md about requests: P1, P3 to P8.
#include <gtest/gtest.h>

#include "fakes.hpp"

namespace foothold::server::testing {
namespace {

using States = std::vector<msg::State>;

States states(const std::vector<msg::PlanEvent>& events) {
  States all;
  for (const auto& event : events) all.push_back(event.state());
  return all;
}

TEST(P1, AHelloOpensThePartitionAndSendsNothing) {
  World world;
  world.query(msg::kNoId);
  EXPECT_TRUE(world.outbox.opened.contains(World::kClient));
  EXPECT_TRUE(world.outbox.messages.empty());
}

TEST(P1, EveryOtherMessageOpensThePartitionToo) {
  World world;
  auto request = good_request();
  request.client(msg::id_of("1"));
  world.submit(request);
  world.cancel(msg::id_of("unheard of"), msg::id_of("2"));
  world.query(msg::id_of("unheard of"), 0, msg::id_of("3"));
  for (const char* client : {"1", "2", "3"}) EXPECT_TRUE(world.outbox.opened.contains(msg::id_of(client))) << client;
}

TEST(P1, AClientIsBusyUntilItsLastRequestIsFinished) {
  World world;
  EXPECT_FALSE(world.jobs->busy_for(World::kClient));
  const auto request = good_request();
  world.submit(request);
  EXPECT_TRUE(world.jobs->busy_for(World::kClient));
  EXPECT_FALSE(world.jobs->busy_for(World::kOther));
  world.end(request.id(), msg::SUCCEEDED);
  EXPECT_FALSE(world.jobs->busy_for(World::kClient));
}

TEST(P3, TheSameIdTwiceIsTheSameRequest) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.step(request.id(), 0);
  world.step(request.id(), 1);
  world.forget_messages();
  auto again = request;
  again.robot("climber");  // whatever else it says
  again.client(World::kOther);
  world.submit(again);
  const auto answer = world.last(request.id(), World::kOther);
  EXPECT_EQ(answer.state(), msg::RUNNING);
  EXPECT_TRUE(answer.answer());
  EXPECT_EQ(answer.steps(), 2U);
  EXPECT_EQ(answer.client(), World::kClient) << "it still belongs to the client that made it";
  EXPECT_EQ(world.steps(request.id(), World::kOther), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_TRUE(world.events(request.id()).empty()) << "the request's own client did not ask";
  EXPECT_EQ(world.planners.runs.size(), 1U);
}

TEST(P3, TheStoredAnswerComesAgainAfterTheEndAndAfterARestart) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.step(request.id(), 0);
  world.end(request.id(), msg::SUCCEEDED);
  const auto final_event = world.last(request.id());
  for (int restarts = 0; restarts < 2; ++restarts) {
    world.forget_messages();
    world.submit(request);
    auto answer = world.last(request.id());
    EXPECT_TRUE(answer.answer());
    answer.answer(false);
    EXPECT_EQ(answer, final_event);
    EXPECT_EQ(world.steps(request.id()), (std::vector<std::uint32_t>{0}));
    world.restart();
  }
  EXPECT_EQ(world.planners.plans_of(request.id()), 1U);
}

TEST(P3, TwoOfTheSameIdInOneBatchMakeOnePlan) {
  World world;
  const auto request = good_request();
  world.jobs->request(request);
  world.jobs->request(request);
  world.jobs->settle();
  EXPECT_EQ(world.planners.runs.size(), 1U);
  EXPECT_EQ(states(world.events(request.id())), (States{msg::RUNNING, msg::RUNNING}));
}

TEST(P4, ARejectedIdIsKeptLikeEveryFinalState) {
  World world;
  auto request = good_request();
  request.robot("nobody");
  world.submit(request);
  EXPECT_EQ(world.last(request.id()).error().code(), msg::UNKNOWN_ROBOT);
  request.robot("walker");
  world.forget_messages();
  world.submit(request);
  EXPECT_EQ(world.state(request.id()), msg::REJECTED);
  EXPECT_TRUE(world.last(request.id()).answer());
  EXPECT_TRUE(world.planners.runs.empty());
}

TEST(P4, TheZeroIdIsRejectedEachTimeAndKeptNowhere) {
  World world;
  auto request = good_request();
  request.id(msg::kNoId);
  for (int i = 0; i < 2; ++i) {
    world.submit(request);
    EXPECT_EQ(world.last(msg::kNoId).error().code(), msg::MALFORMED);
    EXPECT_EQ(world.last(msg::kNoId).error().field(), "id");
    EXPECT_FALSE(world.last(msg::kNoId).answer());
  }
  EXPECT_TRUE(world.journal.durable.empty());
}

TEST(P4, WhatIsKeptOfARejectedRequestIsSmall) {
  World world;
  auto request = good_request();
  request.robot(std::string(60000, 'x'));
  request.goal().contacts().resize(400);
  world.submit(request);
  ASSERT_TRUE(world.journal.durable.contains(request.id()));
  EXPECT_LT(msg::PlanRequest::getCdrSerializedSize(world.journal.durable.at(request.id()).record.request), 500U);
}

TEST(P5, ZeroMeansAnyServerAndAnothersRequestIsLeftAlone) {
  World world;
  auto mine = good_request("mine");
  mine.server(world.options.server);
  auto others = good_request("another's");
  others.server(msg::id_of("another server"));
  world.submit(mine);
  world.submit(others);
  EXPECT_EQ(world.state(mine.id()), msg::RUNNING);
  EXPECT_TRUE(world.events(others.id()).empty());
  EXPECT_FALSE(world.journal.durable.contains(others.id()));
}

TEST(P6, WaitingCountsAndAQueuedRequestExpiresAtOnce) {
  World world;
  for (const char* name : {"1", "2"}) world.submit(good_request(name));
  auto waiting = good_request("waiting");
  waiting.budget(2.0);
  world.submit(waiting);
  EXPECT_EQ(world.state(waiting.id()), msg::QUEUED);
  world.wait(1.999);
  EXPECT_EQ(world.state(waiting.id()), msg::QUEUED);
  world.wait(0.002);
  EXPECT_EQ(world.state(waiting.id()), msg::EXPIRED);
  EXPECT_EQ(world.last(waiting.id()).error().code(), msg::BUDGET_EXHAUSTED);
  EXPECT_EQ(world.planners.plans_of(waiting.id()), 0U);
}

TEST(P6, TheWorkerIsToldWhatIsLeftOfTheBudget) {
  World world;
  for (const char* name : {"1", "2"}) world.submit(good_request(name));
  world.submit(good_request("waiting"));
  world.wait(4.0);
  world.end(msg::id_of("1"), msg::SUCCEEDED);
  EXPECT_NEAR(world.planners.runs.at(world.planners.run_of(msg::id_of("waiting"))).budget_left, 6.0, 1e-9);
}

TEST(P6, ARunningRequestExpiresWhenItsPluginHeeds) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.step(request.id(), 0);
  world.wait(10.0);
  const server::Run run = world.planners.run_of(request.id());
  EXPECT_TRUE(world.planners.runs.at(run).stopped);
  EXPECT_EQ(world.state(request.id()), msg::RUNNING);
  world.end(request.id(), msg::CANCELLED);
  EXPECT_EQ(world.state(request.id()), msg::EXPIRED);
  EXPECT_EQ(world.last(request.id()).steps(), 1U);
  EXPECT_FALSE(world.planners.runs.at(run).killed);
}

TEST(P6, AWorkerThatDoesNotHeedIsKilledAfterTheGraceTime) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.wait(10.0);
  world.wait(world.options.grace - 0.001);
  const server::Run run = world.planners.run_of(request.id());
  EXPECT_FALSE(world.planners.runs.at(run).killed);
  world.wait(0.002);
  EXPECT_TRUE(world.planners.runs.at(run).killed);
  world.lose(request.id(), msg::WORKER_KILLED);
  EXPECT_EQ(world.state(request.id()), msg::EXPIRED);
}

TEST(P6, WhatThePluginReportsAfterTheBudgetsEndDoesNotChangeThat) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.wait(10.0);
  world.end(request.id(), msg::SUCCEEDED);
  EXPECT_EQ(world.state(request.id()), msg::EXPIRED);
}

TEST(P7, AFullQueueRejectsWithATimeToWait) {
  World world;
  world.options.limits.queued = 3;
  world.restart();
  for (const char* name : {"r1", "r2", "q1", "q2", "q3"}) world.submit(good_request(name));
  world.submit(good_request("one too many"));
  const auto event = world.last(msg::id_of("one too many"));
  EXPECT_EQ(event.state(), msg::REJECTED);
  EXPECT_EQ(event.error().code(), msg::QUEUE_FULL);
  EXPECT_GT(event.error().retry_after(), 0.0);
  EXPECT_TRUE(event.error().retryable());
  auto climber = good_request("another robot's, which can start at once");
  climber.robot("climber");
  world.submit(climber);
  EXPECT_EQ(world.state(climber.id()), msg::RUNNING) << "nothing has to wait for it";
}

TEST(P7, HigherPriorityGoesFirstThenTheEarlier) {
  World world;
  for (const char* name : {"r1", "r2"}) world.submit(good_request(name));
  const std::vector<std::pair<const char*, int>> waiting = {{"low", -3}, {"first", 0}, {"second", 0}, {"high", 7}};
  for (const auto& [name, priority] : waiting) {
    auto request = good_request(name);
    request.priority(priority);
    world.submit(request);
  }
  std::vector<Id> order;
  for (const char* ended : {"r1", "high", "first", "second"}) {
    world.end(msg::id_of(ended), msg::SUCCEEDED);
    order.push_back(world.planners.runs.rbegin()->second.request.id());
  }
  EXPECT_EQ(order, (std::vector<Id>{msg::id_of("high"), msg::id_of("first"), msg::id_of("second"), msg::id_of("low")}));
}

TEST(P8, ARequestThatCanStartAtOnceHasNoQueuedEvent) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.end(request.id(), msg::SUCCEEDED);
  EXPECT_EQ(states(world.events(request.id())), (States{msg::RUNNING, msg::SUCCEEDED}));
}

TEST(P8, ARequestThatEndsInTheBatchInWhichItBeganHasNoRunningEvent) {
  World world;
  const auto request = good_request();
  world.jobs->request(request);
  world.jobs->on_run_end(1, {.state = msg::SUCCEEDED});
  world.jobs->settle();
  EXPECT_EQ(states(world.events(request.id())), (States{msg::SUCCEEDED}));
}

TEST(P8, ARequestThatWaitsIsToldSo) {
  World world;
  for (const char* name : {"r1", "r2", "waiting"}) world.submit(good_request(name));
  world.end(msg::id_of("r1"), msg::SUCCEEDED);
  world.end(msg::id_of("waiting"), msg::FAILED, msg::NO_PATH);
  EXPECT_EQ(states(world.events(msg::id_of("waiting"))), (States{msg::QUEUED, msg::RUNNING, msg::FAILED}));
}

}  // namespace
}  // namespace foothold::server::testing
