// The rules of idl/PROTOCOL.md for who watches and for more than one server: P31 and on.
#include <gtest/gtest.h>

#include "fakes.hpp"

namespace foothold::server::testing {
namespace {

msg::PlanRequest of_unit(const std::string& name, const std::string& unit) {
  auto request = good_request(name);
  request.unit(unit);
  return request;
}

TEST(P31, EveryEventNamesRobotAndUnit) {
  World world;
  for (const char* name : {"r1", "r2", "waiting"}) world.submit(of_unit(name, std::string("unit of ") + name));
  world.query(msg::id_of("waiting"), 0, World::kOther);
  world.end(msg::id_of("r1"), msg::SUCCEEDED);
  world.end(msg::id_of("waiting"), msg::FAILED, msg::NO_PATH);
  auto refused = of_unit("refused", "unit of refused");
  refused.budget(-1.0);
  world.submit(refused);
  world.restart();  // r2 ends
  world.query(msg::id_of("waiting"));
  std::size_t seen = 0;
  for (const char* name : {"r1", "r2", "waiting", "refused"})
    for (const Id& client : {World::kClient, World::kOther})
      for (const auto& event : world.events(msg::id_of(name), client)) {
        ++seen;
        EXPECT_EQ(event.robot(), "walker") << name;
        EXPECT_EQ(event.unit(), std::string("unit of ") + name);
      }
  EXPECT_EQ(seen, 10U);
}

TEST(P31, EveryStepNamesItsServerAlsoAfterARestart) {
  World world;
  auto request = good_request();
  request.resume(true);
  world.submit(request);
  world.step(request.id(), 0);
  world.restart();
  world.step(request.id(), 0);  // the same again: it is compared with what the journal holds
  world.step(request.id(), 1);
  std::size_t seen = 0;
  for (const auto& message : world.outbox.messages) {
    if (message.event) continue;
    const auto step = msg::decode<msg::Step>(message.step);
    ASSERT_TRUE(step);
    EXPECT_EQ(step->server(), world.options.server);
    ++seen;
  }
  EXPECT_EQ(seen, 3U);
}

TEST(P31, ARequestOfNamesThatBreakTheLimitsIsNotEchoed) {
  World world;
  auto request = of_unit("too long", std::string(5000, 'u'));
  world.submit(request);
  EXPECT_EQ(world.last(request.id()).error().field(), "unit");
  EXPECT_TRUE(world.last(request.id()).unit().empty());
  request.id(msg::kNoId);
  world.submit(request);
  EXPECT_TRUE(world.last(msg::kNoId).unit().empty());
}

// To this server, to be planned again after a restart.
msg::PlanRequest addressed(const World& world, const std::string& name, bool resume = true) {
  auto request = good_request(name);
  request.server(world.options.server);
  request.resume(resume);
  return request;
}

void move_to_another(World& world, msg::PlanRequest request) {
  request.server(msg::id_of("another server"));
  world.submit(request);
}

TEST(P35, ARunningRequestThatItsClientAddressesToAnotherServerEndsMoved) {
  World world;
  const auto request = addressed(world, "r");
  world.submit(request);
  world.step(request.id(), 0);
  move_to_another(world, request);
  EXPECT_TRUE(world.planners.runs.at(world.planners.run_of(request.id())).stopped);
  world.end(request.id(), msg::CANCELLED);
  const auto end = world.last(request.id());
  EXPECT_EQ(end.state(), msg::CANCELLED);
  EXPECT_EQ(end.error().code(), msg::MOVED);
  EXPECT_NE(end.error().message().find(msg::to_hex(msg::id_of("another server"))), std::string::npos);
  EXPECT_EQ(end.steps(), 1U);
}

TEST(P35, AQueuedOneEndsAtOnceAndAFinishedOneStays) {
  World world;
  for (const char* name : {"r1", "r2", "waiting"}) world.submit(addressed(world, name));
  move_to_another(world, addressed(world, "waiting"));
  EXPECT_EQ(world.last(msg::id_of("waiting")).error().code(), msg::MOVED);
  world.end(msg::id_of("r1"), msg::SUCCEEDED);
  world.forget_messages();
  move_to_another(world, addressed(world, "r1"));
  EXPECT_TRUE(world.events(msg::id_of("r1")).empty());
  EXPECT_EQ(world.journal.durable.at(msg::id_of("r1")).record.final_event->state(), msg::SUCCEEDED);
}

TEST(P35, OnlyItsOwnClientMovesARequest) {
  World world;
  auto request = addressed(world, "r");
  world.submit(request);
  request.client(World::kOther);
  move_to_another(world, request);
  EXPECT_FALSE(world.planners.runs.at(world.planners.run_of(request.id())).stopped);
}

TEST(P36, AnAddressedRequestIsNotPlannedAgainBeforeItsClientsWord) {
  World world;
  world.others_serve = true;
  const auto request = addressed(world, "r");
  world.submit(request);
  world.step(request.id(), 0);
  world.forget_messages();
  world.restart();
  const auto held = world.last(request.id());
  EXPECT_EQ(held.state(), msg::QUEUED);
  EXPECT_EQ(held.error().code(), msg::SERVER_RESTARTED);
  world.wait(8.0);
  EXPECT_EQ(world.planners.plans_of(request.id()), 1U);
  world.submit(request);  // the word
  EXPECT_EQ(world.planners.plans_of(request.id()), 1U) << "it may be old: a move would follow at once";
  world.wait(world.options.word_settles);
  EXPECT_EQ(world.planners.plans_of(request.id()), 2U);
  EXPECT_EQ(world.last(request.id()).state(), msg::RUNNING);
  world.step(request.id(), 0);
  world.step(request.id(), 1);
  world.end(request.id(), msg::SUCCEEDED);
  EXPECT_EQ(world.last(request.id()).state(), msg::SUCCEEDED);
  EXPECT_EQ(world.last(request.id()).steps(), 2U);
}

TEST(P36, AMovedRequestIsNeverPlannedAgain) {
  // Whether the old word comes once more before the news, as a late reader is told both, or the news alone.
  for (const bool old_word : {false, true}) {
    World world;
    world.others_serve = true;
    const auto request = addressed(world, "r");
    world.submit(request);
    world.restart();
    if (old_word) world.submit(request);
    world.wait(0.2);
    move_to_another(world, request);
    EXPECT_EQ(world.last(request.id()).state(), msg::CANCELLED);
    EXPECT_EQ(world.last(request.id()).error().code(), msg::MOVED);
    world.submit(request);
    world.wait(20.0);
    EXPECT_EQ(world.planners.plans_of(request.id()), 1U);
    EXPECT_EQ(world.last(request.id()).error().code(), msg::MOVED) << "the stored end, again";
  }
}

TEST(P36, WithoutAWordItExpiresWhereOthersServe) {
  World world;
  world.others_serve = true;
  const auto request = addressed(world, "r");
  world.submit(request);
  world.restart();
  world.wait(11.0);
  EXPECT_EQ(world.last(request.id()).state(), msg::EXPIRED);
  EXPECT_EQ(world.planners.plans_of(request.id()), 1U);
}

TEST(P36, WithoutAWordALoneServerPlansItAgain) {
  World world;
  const auto request = addressed(world, "r");
  world.submit(request);
  world.restart();
  world.wait(world.options.word_wait - 0.1);
  EXPECT_EQ(world.planners.plans_of(request.id()), 1U);
  world.wait(0.2);
  EXPECT_EQ(world.planners.plans_of(request.id()), 2U);
}

TEST(P36, WhatIsHeldCanBeCancelledAndStopped) {
  World world;
  world.others_serve = true;
  for (const char* name : {"1", "2"}) world.submit(addressed(world, name));
  world.restart();
  world.cancel(msg::id_of("1"));
  EXPECT_EQ(world.last(msg::id_of("1")).error().code(), msg::CANCELLED_BY_CLIENT);
  world.stop();
  EXPECT_EQ(world.last(msg::id_of("2")).error().code(), msg::SERVER_STOPPING);
  EXPECT_TRUE(world.jobs->idle());
}

TEST(P36, OfAnotherClientTheRequestIsNoWord) {
  World world;
  world.others_serve = true;
  auto request = addressed(world, "r");
  world.submit(request);
  world.restart();
  request.client(World::kOther);
  world.submit(request);
  world.wait(8.0);
  EXPECT_EQ(world.planners.plans_of(request.id()), 1U);
}

}  // namespace
}  // namespace foothold::server::testing
