// The rules of idl/PROTOCOL.md about faults: P19 to P24, and P29.
#include <gtest/gtest.h>

#include "fakes.hpp"

namespace foothold::server::testing {
namespace {

TEST(P19, AWorkerThatDiesEndsItsOneRequest) {
  World world;
  const auto dying = good_request("dying");
  const auto living = good_request("living");
  world.submit(dying);
  world.submit(living);
  world.step(dying.id(), 0);
  world.lose(dying.id(), msg::WORKER_CRASHED);
  EXPECT_EQ(world.state(dying.id()), msg::CRASHED);
  EXPECT_EQ(world.last(dying.id()).error().code(), msg::WORKER_CRASHED);
  EXPECT_NE(world.last(dying.id()).error().message().find("SIGSEGV"), std::string::npos);
  EXPECT_EQ(world.last(dying.id()).steps(), 1U);
  world.step(living.id(), 0);
  world.end(living.id(), msg::SUCCEEDED);
  EXPECT_EQ(world.state(living.id()), msg::SUCCEEDED);
}

TEST(P19, OutOfMemoryIsACrashWhetherTheWorkerDiedOrSaidSo) {
  World world;
  const auto died = good_request("died");
  const auto said = good_request("said");
  world.submit(died);
  world.submit(said);
  world.lose(died.id(), msg::OUT_OF_MEMORY);
  world.end(said.id(), msg::FAILED, msg::OUT_OF_MEMORY);
  for (const Id& id : {died.id(), said.id()}) {
    EXPECT_EQ(world.state(id), msg::CRASHED);
    EXPECT_EQ(world.last(id).error().code(), msg::OUT_OF_MEMORY);
  }
}

TEST(P19, APlannerThatStopsThoughNobodyToldItToHasBrokenTheProtocol) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.end(request.id(), msg::CANCELLED);
  EXPECT_EQ(world.state(request.id()), msg::FAILED);
  EXPECT_EQ(world.last(request.id()).error().code(), msg::WORKER_PROTOCOL);
}

TEST(P20, ARefusedStepEndsTheRequestWithTheCheckersSentence) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.step(request.id(), 0);
  world.end(request.id(), msg::FAILED, msg::STEP_REFUSED);
  EXPECT_EQ(world.state(request.id()), msg::FAILED);
  EXPECT_EQ(world.last(request.id()).error().code(), msg::STEP_REFUSED);
  EXPECT_EQ(world.last(request.id()).error().message(), "the planner's message");
  EXPECT_EQ(world.last(request.id()).error().field(), "goal.base");
  EXPECT_EQ(world.last(request.id()).steps(), 1U);
}

TEST(P21, AQuarantinedRobotsRequestsAreRejectedAndWhatWaitsEnds) {
  World world;
  for (const char* name : {"r1", "r2", "waiting"}) world.submit(good_request(name));
  auto& walker = world.planners.robots.at("walker");
  walker.info.state(msg::QUARANTINED);
  walker.info.reason("3 crashes within 60 s");
  walker.retry_after = 60.0;
  world.jobs->on_slots_changed("walker");
  world.jobs->settle();
  EXPECT_EQ(world.state(msg::id_of("waiting")), msg::FAILED);
  EXPECT_EQ(world.last(msg::id_of("waiting")).error().code(), msg::ROBOT_QUARANTINED);
  world.submit(good_request("new"));
  EXPECT_EQ(world.state(msg::id_of("new")), msg::REJECTED);
  EXPECT_EQ(world.last(msg::id_of("new")).error().code(), msg::ROBOT_QUARANTINED);
  EXPECT_EQ(world.last(msg::id_of("new")).error().retry_after(), 60.0);
  world.end(msg::id_of("r1"), msg::SUCCEEDED);
  EXPECT_EQ(world.state(msg::id_of("r1")), msg::SUCCEEDED) << "what runs may end";
}

TEST(P22, WhatWasUnfinishedEndsAsServerRestarted) {
  World world;
  for (const char* name : {"r1", "r2", "waiting"}) world.submit(good_request(name));
  world.step(msg::id_of("r1"), 0);
  world.forget_messages();
  world.restart();
  for (const char* name : {"r1", "r2", "waiting"}) {
    EXPECT_EQ(world.state(msg::id_of(name)), msg::FAILED) << name;
    EXPECT_EQ(world.last(msg::id_of(name)).error().code(), msg::SERVER_RESTARTED) << name;
  }
  EXPECT_EQ(world.last(msg::id_of("r1")).steps(), 1U);
  world.forget_messages();
  world.restart();
  EXPECT_TRUE(world.outbox.messages.empty()) << "once only";
}

TEST(P22, WhatWasFinishedButNotCommittedEndsOnceAllTheSame) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.jobs->on_run_end(1, {.state = msg::SUCCEEDED});  // no settle: killed before the commit
  world.restart();
  EXPECT_EQ(world.state(request.id()), msg::FAILED);
  EXPECT_EQ(world.events(request.id()).size(), 2U);
}

TEST(P22, WithResumeItIsPlannedAgainAndTheStepsAreSentAgain) {
  World world;
  auto request = good_request();
  request.resume(true);
  world.submit(request);
  world.step(request.id(), 0, "one");
  world.step(request.id(), 1, "two");
  world.clock.advance(4.0);
  world.forget_messages();
  world.restart();
  EXPECT_EQ(world.state(request.id()), msg::RUNNING);
  EXPECT_NEAR(world.planners.runs.at(2).budget_left, 6.0, 1e-9) << "counted from the first receipt";
  world.step(request.id(), 0, "one");
  world.step(request.id(), 1, "two");
  world.step(request.id(), 2, "three");
  world.end(request.id(), msg::SUCCEEDED);
  EXPECT_EQ(world.steps(request.id()), (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(world.state(request.id()), msg::SUCCEEDED);
  EXPECT_EQ(world.last(request.id()).steps(), 3U);
  EXPECT_EQ(world.journal.durable.at(request.id()).steps.size(), 3U);
}

TEST(P22, AResumedPlanThatDiffersEndsAsServerRestarted) {
  World world;
  auto request = good_request();
  request.resume(true);
  world.submit(request);
  world.step(request.id(), 0, "one");
  world.step(request.id(), 1, "two");
  world.restart();
  world.forget_messages();
  world.step(request.id(), 0, "one");
  world.step(request.id(), 1, "another");
  EXPECT_EQ(world.steps(request.id()), (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(world.state(request.id()), msg::FAILED);
  EXPECT_EQ(world.last(request.id()).error().code(), msg::SERVER_RESTARTED);
  EXPECT_EQ(world.last(request.id()).steps(), 2U) << "what the journal holds";
  EXPECT_TRUE(world.planners.runs.at(2).stopped);
}

TEST(P22, AResumedPlanThatIsShorterEndsAsServerRestarted) {
  World world;
  auto request = good_request();
  request.resume(true);
  world.submit(request);
  world.step(request.id(), 0, "one");
  world.step(request.id(), 1, "two");
  world.restart();
  world.step(request.id(), 0, "one");
  world.end(request.id(), msg::SUCCEEDED);
  EXPECT_EQ(world.state(request.id()), msg::FAILED);
  EXPECT_EQ(world.last(request.id()).error().code(), msg::SERVER_RESTARTED);
}

TEST(P22, AResumedRequestWhoseBudgetIsOverExpires) {
  World world;
  auto request = good_request();
  request.resume(true);
  world.submit(request);
  world.clock.advance(11.0);
  world.restart();
  EXPECT_EQ(world.state(request.id()), msg::EXPIRED);
  EXPECT_EQ(world.planners.plans_of(request.id()), 1U);
}

TEST(P22, AResumedRequestWhoseRobotIsGoneFailsAndSaysSo) {
  World world;
  auto request = good_request();
  request.resume(true);
  world.submit(request);
  world.planners.robots.at("walker").info.state(msg::UNAVAILABLE);
  world.restart();
  EXPECT_EQ(world.state(request.id()), msg::FAILED);
  EXPECT_EQ(world.last(request.id()).error().code(), msg::ROBOT_UNAVAILABLE);
}

TEST(P22, ResumedRequestsGoInTheOrderOfTheirReceipt) {
  World world;
  for (int i = 0; i < 5; ++i) {
    auto request = good_request(std::to_string(i));
    request.resume(true);
    world.submit(request);
  }
  world.restart();
  EXPECT_EQ(world.planners.runs.at(3).request.id(), msg::id_of("0"));
  EXPECT_EQ(world.planners.runs.at(4).request.id(), msg::id_of("1"));
  EXPECT_EQ(world.state(msg::id_of("2")), msg::QUEUED);
}

TEST(P22, AWallClockThatWasSetBackDoesNotLengthenTheBudget) {
  World world;
  auto request = good_request();
  request.resume(true);
  world.submit(request);
  world.clock.wall -= 3600'000'000'000;
  world.restart();
  EXPECT_LE(world.planners.runs.at(2).budget_left, 10.0);
}

TEST(P23, AServerToldToStopEndsWhatIsQueuedAndRunningAndRejectsTheRest) {
  World world;
  for (const char* name : {"r1", "r2", "waiting"}) world.submit(good_request(name));
  world.stop();
  EXPECT_EQ(world.state(msg::id_of("waiting")), msg::CANCELLED);
  EXPECT_EQ(world.state(msg::id_of("r1")), msg::RUNNING);
  world.submit(good_request("late"));
  EXPECT_EQ(world.last(msg::id_of("late")).error().code(), msg::SERVER_STOPPING);
  EXPECT_EQ(world.state(msg::id_of("late")), msg::REJECTED);
  EXPECT_FALSE(world.jobs->idle());
  world.end(msg::id_of("r1"), msg::CANCELLED);
  world.wait(world.options.grace + 0.001);
  EXPECT_TRUE(world.planners.runs.at(2).killed);
  world.lose(msg::id_of("r2"), msg::WORKER_KILLED);
  for (const char* name : {"r1", "r2", "waiting"}) {
    EXPECT_EQ(world.state(msg::id_of(name)), msg::CANCELLED) << name;
    EXPECT_EQ(world.last(msg::id_of(name)).error().code(), msg::SERVER_STOPPING) << name;
  }
  EXPECT_TRUE(world.jobs->idle());
  world.restart();
  EXPECT_EQ(world.last(msg::id_of("r1")).error().code(), msg::SERVER_STOPPING) << "nothing was left unfinished";
}

TEST(P24, AClientThatVanishesCanAskAfterwards) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.step(request.id(), 0);
  world.end(request.id(), msg::SUCCEEDED);
  world.forget_messages();
  world.query(request.id(), 0, World::kOther);
  EXPECT_EQ(world.last(request.id(), World::kOther).state(), msg::SUCCEEDED);
  EXPECT_EQ(world.steps(request.id(), World::kOther).size(), 1U);
}

TEST(P29, FinalStatesAreForgottenAfterTheRetentionTime) {
  World world;
  world.options.retention = 100.0;
  world.restart();
  const auto old = good_request("old");
  world.submit(old);
  world.end(old.id(), msg::SUCCEEDED);
  world.wait(90.0);
  world.query(old.id());
  EXPECT_EQ(world.state(old.id()), msg::SUCCEEDED);
  auto running = good_request("running all the time");
  running.budget(3000.0);
  world.submit(running);
  world.wait(200.0);
  world.query(old.id());
  EXPECT_EQ(world.state(old.id()), msg::UNKNOWN);
  world.query(running.id());
  EXPECT_EQ(world.state(running.id()), msg::RUNNING);
}

}  // namespace
}  // namespace foothold::server::testing
