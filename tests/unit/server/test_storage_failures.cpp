// What clients are told when the journal cannot be written or read, and that the server goes on.
#include <gtest/gtest.h>

#include "fakes.hpp"

namespace foothold::server::testing {
namespace {

TEST(StorageFailure, ARequestWhoseReceiptCannotBeStoredIsRejected) {
  World world;
  world.journal.full = true;
  const auto request = good_request();
  world.submit(request);
  ASSERT_EQ(world.events(request.id()).size(), 1U) << "RUNNING was not told";
  EXPECT_EQ(world.state(request.id()), msg::REJECTED);
  EXPECT_EQ(world.last(request.id()).error().code(), msg::STORAGE_FAILED);
  EXPECT_TRUE(world.planners.runs.at(1).stopped);
  EXPECT_EQ(world.complaints.size(), 1U);
}

TEST(StorageFailure, ARunningRequestFailsWithTheStepsThatAreStored) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.step(request.id(), 0);
  world.journal.full = true;
  world.step(request.id(), 1);
  EXPECT_EQ(world.state(request.id()), msg::FAILED);
  EXPECT_EQ(world.last(request.id()).error().code(), msg::STORAGE_FAILED);
  EXPECT_EQ(world.last(request.id()).steps(), 1U);
  EXPECT_EQ(world.steps(request.id()), (std::vector<std::uint32_t>{0}));
  world.wait(0.5);
  EXPECT_TRUE(world.planners.runs.at(1).killed) << "it did not heed its stop token";
  world.lose(request.id(), msg::WORKER_KILLED);
  EXPECT_EQ(world.events(request.id()).size(), 2U);
}

TEST(StorageFailure, AnEndThatCannotBeStoredIsToldAsStorageFailedAndStoredLater) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.journal.full = true;
  world.end(request.id(), msg::SUCCEEDED);
  EXPECT_EQ(world.last(request.id()).error().code(), msg::STORAGE_FAILED);
  world.query(request.id());
  EXPECT_EQ(world.last(request.id()).error().code(), msg::STORAGE_FAILED) << "answered from memory";
  world.journal.full = false;
  world.wait(1.1);
  ASSERT_TRUE(world.journal.durable.at(request.id()).record.final_event);
  world.restart();
  world.query(request.id());
  EXPECT_EQ(world.last(request.id()).error().code(), msg::STORAGE_FAILED) << "the same end for ever";
}

TEST(StorageFailure, ARejectionIsToldAsItIsAndStoredLater) {
  World world;
  world.journal.full = true;
  auto request = good_request();
  request.robot("nobody");
  world.submit(request);
  EXPECT_EQ(world.last(request.id()).error().code(), msg::UNKNOWN_ROBOT);
  world.journal.full = false;
  world.wait(1.1);
  EXPECT_TRUE(world.journal.durable.contains(request.id()));
}

TEST(StorageFailure, TheServerRecoversWhenThereIsSpaceAgain) {
  World world;
  for (const char* name : {"r1", "r2", "waiting"}) world.submit(good_request(name));
  world.journal.full = true;
  world.step(msg::id_of("r1"), 0);
  world.end(msg::id_of("r1"), msg::CANCELLED);
  EXPECT_EQ(world.planners.plans_of(msg::id_of("waiting")), 0U) << "nothing new starts while nothing can be stored";
  world.submit(good_request("meanwhile"));
  EXPECT_EQ(world.planners.plans_of(msg::id_of("meanwhile")), 0U);
  EXPECT_EQ(world.last(msg::id_of("meanwhile")).error().code(), msg::STORAGE_FAILED);
  world.journal.full = false;
  world.wait(1.1);
  EXPECT_EQ(world.state(msg::id_of("waiting")), msg::RUNNING);
  world.end(msg::id_of("waiting"), msg::SUCCEEDED);
  EXPECT_EQ(world.state(msg::id_of("waiting")), msg::SUCCEEDED);
  world.submit(good_request("afterwards"));
  EXPECT_EQ(world.state(msg::id_of("afterwards")), msg::RUNNING);
}

TEST(StorageFailure, OthersThatNothingWasWrittenOfGoOn) {
  World world;
  const auto first = good_request("first");
  const auto second = good_request("second");
  world.submit(first);
  world.submit(second);
  world.journal.full = true;
  world.step(first.id(), 0);
  world.journal.full = false;
  world.step(second.id(), 0);
  world.end(second.id(), msg::SUCCEEDED);
  EXPECT_EQ(world.state(first.id()), msg::FAILED);
  EXPECT_EQ(world.state(second.id()), msg::SUCCEEDED);
}

TEST(StorageFailure, AnUnreadableJournalNeverLeadsToASecondPlan) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.end(request.id(), msg::SUCCEEDED);
  world.journal.unreadable = true;
  world.submit(request);
  EXPECT_EQ(world.last(request.id()).error().code(), msg::STORAGE_FAILED);
  EXPECT_EQ(world.last(request.id()).state(), msg::UNKNOWN);
  EXPECT_TRUE(world.last(request.id()).answer());
  EXPECT_EQ(world.planners.runs.size(), 1U);
}

}  // namespace
}  // namespace foothold::server::testing
