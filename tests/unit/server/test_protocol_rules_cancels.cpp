// The rules of idl/PROTOCOL.md about cancels: P10 to P13.
#include <gtest/gtest.h>

#include "fakes.hpp"

namespace foothold::server::testing {
namespace {

TEST(P10, AQueuedRequestIsCancelledAtOnce) {
  World world;
  for (const char* name : {"r1", "r2", "waiting"}) world.submit(good_request(name));
  world.cancel(msg::id_of("waiting"), World::kClient, "changed my mind");
  const auto event = world.last(msg::id_of("waiting"));
  EXPECT_EQ(event.state(), msg::CANCELLED);
  EXPECT_EQ(event.error().code(), msg::CANCELLED_BY_CLIENT);
  EXPECT_NE(event.error().message().find("changed my mind"), std::string::npos);
  EXPECT_FALSE(event.answer());
  world.end(msg::id_of("r1"), msg::SUCCEEDED);
  EXPECT_EQ(world.planners.plans_of(msg::id_of("waiting")), 0U);
}

TEST(P10, ARunningRequestIsCancelledWhenItsPluginHeeds) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.step(request.id(), 0);
  world.cancel(request.id());
  EXPECT_EQ(world.state(request.id()), msg::RUNNING);
  EXPECT_TRUE(world.planners.runs.at(world.planners.run_of(request.id())).stopped);
  world.end(request.id(), msg::CANCELLED);
  EXPECT_EQ(world.state(request.id()), msg::CANCELLED);
  EXPECT_EQ(world.last(request.id()).summary().steps(), 1U);
}

TEST(P10, AWorkerThatDoesNotHeedIsKilledAfterTheGraceTime) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.cancel(request.id());
  world.wait(world.options.grace + 0.001);
  EXPECT_TRUE(world.planners.runs.at(world.planners.run_of(request.id())).killed);
  world.lose(request.id(), msg::WORKER_KILLED);
  EXPECT_EQ(world.state(request.id()), msg::CANCELLED);
  EXPECT_EQ(world.last(request.id()).error().code(), msg::CANCELLED_BY_CLIENT);
}

TEST(P10, AReportThatIsAlreadyThereStands) {
  World world;
  const auto request = good_request();
  world.submit(request);
  RunEnd end;
  end.state = msg::SUCCEEDED;
  msg::CancelRequest cancel;
  cancel.id(request.id());
  cancel.client(World::kClient);
  world.jobs->on_run_end(world.planners.run_of(request.id()), end);  // both in one batch
  world.jobs->cancel(cancel);
  world.jobs->settle();
  const auto events = world.events(request.id());
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[1].state(), msg::SUCCEEDED);
  EXPECT_FALSE(events[1].answer());
  EXPECT_EQ(events[2].state(), msg::SUCCEEDED);
  EXPECT_TRUE(events[2].answer());
}

TEST(P10, AReportThatComesAfterTheCancelDoesNotStand) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.cancel(request.id());
  world.end(request.id(), msg::SUCCEEDED);
  EXPECT_EQ(world.state(request.id()), msg::CANCELLED);
}

TEST(P11, AnEarlyCancelIsAnsweredUnknownAndRememberedTenSeconds) {
  World world;
  const auto request = good_request();
  world.cancel(request.id(), World::kOther, "too early");
  const auto answer = world.last(request.id(), World::kOther);
  EXPECT_EQ(answer.state(), msg::UNKNOWN);
  EXPECT_EQ(answer.error().code(), msg::UNKNOWN_REQUEST);
  EXPECT_TRUE(answer.answer());
  world.wait(9.9);
  world.submit(request);
  EXPECT_EQ(world.state(request.id()), msg::CANCELLED);
  EXPECT_NE(world.last(request.id()).error().message().find("too early"), std::string::npos);
  EXPECT_TRUE(world.planners.runs.empty());
}

TEST(P11, AfterTenSecondsTheCancelIsForgotten) {
  World world;
  const auto request = good_request();
  world.cancel(request.id());
  world.wait(10.1);
  world.submit(request);
  EXPECT_EQ(world.state(request.id()), msg::RUNNING);
}

TEST(P11, TheMemoryOfEarlyCancelsIsBoundedAndSaysSo) {
  World world;
  for (std::size_t i = 0; i < EarlyCancels::kMost; ++i) world.cancel(msg::id_of(std::to_string(i)));
  world.cancel(msg::id_of("one more"));
  EXPECT_NE(world.last(msg::id_of("one more")).error().message().find("not remembered"), std::string::npos);
  world.wait(11.0);
  world.cancel(msg::id_of("later"));
  EXPECT_EQ(world.last(msg::id_of("later")).error().message().find("not remembered"), std::string::npos);
}

TEST(P12, ACancelOfAFinishedRequestIsAnsweredAndChangesNothing) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.end(request.id(), msg::SUCCEEDED);
  auto final_event = world.last(request.id());
  world.forget_messages();
  world.cancel(request.id(), World::kOther);
  final_event.answer(true);
  EXPECT_EQ(world.last(request.id(), World::kOther), final_event);
  EXPECT_EQ(world.outbox.messages.size(), 1U);
}

TEST(P12, ASecondCancelIsAnsweredWithTheCurrentState) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.cancel(request.id());
  world.forget_messages();
  world.cancel(request.id());
  EXPECT_EQ(world.state(request.id()), msg::RUNNING);
  EXPECT_TRUE(world.last(request.id()).answer());
  world.end(request.id(), msg::CANCELLED);
  EXPECT_EQ(world.state(request.id()), msg::CANCELLED);
  EXPECT_EQ(world.events(request.id()).size(), 2U);
}

TEST(P12, ASecondCancelInTheBatchOfTheEndIsAnsweredAfterTheEnd) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.cancel(request.id());
  world.forget_messages();
  msg::CancelRequest again;
  again.id(request.id());
  again.client(World::kClient);
  world.jobs->cancel(again);  // not settled: what follows is of the same batch
  world.end(request.id(), msg::CANCELLED);
  const auto events = world.events(request.id());
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].state(), msg::CANCELLED);
  EXPECT_FALSE(events[0].answer());
  EXPECT_TRUE(events[1].answer());
}

TEST(P12, ACancelOfARequestWhoseBudgetIsOverChangesNothing) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.wait(10.0);
  world.cancel(request.id());
  EXPECT_TRUE(world.last(request.id()).answer());
  world.end(request.id(), msg::CANCELLED);
  EXPECT_EQ(world.state(request.id()), msg::EXPIRED);
}

TEST(P13, WhoeverKnowsTheIdMayCancelAndTheChangeGoesToItsOwnClient) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.forget_messages();
  world.cancel(request.id(), World::kOther);
  world.end(request.id(), msg::CANCELLED);
  EXPECT_EQ(world.state(request.id()), msg::CANCELLED);
  EXPECT_TRUE(world.events(request.id(), World::kOther).empty()) << "the change is the client's";
}

TEST(P13, ACancelWhoseReasonIsTooLongHoldsAndSaysThatTheReasonIsLeftOut) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.cancel(request.id(), World::kClient, std::string(5000, 'x'));
  world.end(request.id(), msg::CANCELLED);
  EXPECT_LT(world.last(request.id()).error().message().size(), 200U);
  EXPECT_NE(world.last(request.id()).error().message().find("5000 octets"), std::string::npos);
}

TEST(P13, ACancelOfTheZeroIdIsUnknownAndNotRemembered) {
  World world;
  world.cancel(msg::kNoId);
  EXPECT_EQ(world.last(msg::kNoId).state(), msg::UNKNOWN);
  EXPECT_EQ(world.outbox.messages.size(), 1U);
}

}  // namespace
}  // namespace foothold::server::testing
