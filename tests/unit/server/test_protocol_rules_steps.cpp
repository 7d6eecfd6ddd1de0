// The rules of idl/PROTOCOL.md about steps and queries: P14 to P18, and about shapes and summaries, which travel with them.
#include <gtest/gtest.h>

#include "fakes.hpp"

namespace foothold::server::testing {
namespace {

using Indices = std::vector<std::uint32_t>;

msg::Shape box(const std::string& name) {
  msg::Shape shape;
  shape.body(name);
  shape.pose().orientation().w(1.0);
  return shape;
}

TEST(P14, StepsAreNumberedFromZeroAndTheFinalEventSaysHowMany) {
  World world;
  const auto request = good_request();
  world.submit(request);
  for (std::uint32_t i = 0; i < 5; ++i) world.step(request.id(), i);
  world.end(request.id(), msg::PARTIAL, msg::NO_PATH);
  EXPECT_EQ(world.steps(request.id()), (Indices{0, 1, 2, 3, 4}));
  EXPECT_EQ(world.last(request.id()).steps(), 5U);
  EXPECT_EQ(world.last(request.id()).summary().steps(), 5U);
}

TEST(P14, AGapInWhatAWorkerSaysEndsTheRequest) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.step(request.id(), 0);
  world.step(request.id(), 2);
  EXPECT_EQ(world.state(request.id()), msg::FAILED);
  EXPECT_EQ(world.last(request.id()).error().code(), msg::WORKER_PROTOCOL);
  EXPECT_EQ(world.last(request.id()).steps(), 1U);
  EXPECT_TRUE(world.planners.runs.at(world.planners.run_of(request.id())).stopped);
  world.wait(1.0);
  EXPECT_TRUE(world.planners.runs.at(world.planners.run_of(request.id())).killed);
  world.lose(request.id(), msg::WORKER_KILLED);
  EXPECT_EQ(world.events(request.id()).size(), 2U) << "nothing after the end";
}

TEST(P16, NoStepIsSentAfterTheFinalStateWasDecided) {
  World world;
  const auto request = good_request();
  world.submit(request);
  world.step(request.id(), 0);
  world.cancel(request.id());
  world.step(request.id(), 1);
  world.step(request.id(), 2);
  world.end(request.id(), msg::CANCELLED);
  EXPECT_EQ(world.steps(request.id()), (Indices{0}));
  EXPECT_EQ(world.last(request.id()).steps(), 1U);
  EXPECT_EQ(world.journal.durable.at(request.id()).steps.size(), 1U);
}

TEST(P16, NothingIsToldBeforeItIsCommitted) {
  World world;
  const auto request = good_request();
  world.jobs->request(request);
  EXPECT_EQ(world.planners.runs.size(), 1U) << "the worker is at it already";
  EXPECT_TRUE(world.outbox.messages.empty());
  world.jobs->on_run_step(1, 0, step_bytes(request.id(), 0, "a step"));
  world.jobs->on_run_end(1, {.state = msg::SUCCEEDED});
  EXPECT_TRUE(world.outbox.messages.empty());
  const int commits = world.journal.commits;
  world.jobs->settle();
  EXPECT_EQ(world.journal.commits, commits + 1) << "one commit for the batch";
  EXPECT_EQ(world.outbox.messages.size(), 2U) << "the step and the end";
}

TEST(P16, OnlyAReceiptThatAWorkerHasAlreadyMayWaitForTheWorkersFirstWord) {
  World world;
  const auto request = good_request();
  world.jobs->request(request);
  EXPECT_FALSE(world.jobs->urgent());
  world.jobs->on_run_step(1, 0, step_bytes(request.id(), 0, "a step"));
  EXPECT_TRUE(world.jobs->urgent());
  world.jobs->settle();
  EXPECT_FALSE(world.jobs->urgent());
  for (const char* name : {"second", "waits"}) world.jobs->request(good_request(name));
  EXPECT_TRUE(world.jobs->urgent()) << "QUEUED is told at once";
  world.jobs->settle();
  world.cancel(msg::id_of("waits"));
  msg::StateQuery query;
  query.request(request.id());
  world.jobs->query(query);
  EXPECT_TRUE(world.jobs->urgent());
}

TEST(P17, AQueryIsAnsweredWithTheCurrentEventAndTheStepsFromThereOn) {
  World world;
  const auto request = good_request();
  world.submit(request);
  for (std::uint32_t i = 0; i < 4; ++i) world.step(request.id(), i);
  for (int round = 0; round < 3; ++round) {  // running, ended, restarted
    world.forget_messages();
    world.query(request.id(), 2, World::kOther);
    EXPECT_TRUE(world.last(request.id(), World::kOther).answer());
    EXPECT_EQ(world.last(request.id(), World::kOther).state(), round == 0 ? msg::RUNNING : msg::SUCCEEDED);
    EXPECT_EQ(world.last(request.id(), World::kOther).steps(), 4U);
    EXPECT_EQ(world.steps(request.id(), World::kOther), (Indices{2, 3}));
    world.query(request.id(), 4, World::kOther);
    EXPECT_EQ(world.steps(request.id(), World::kOther).size(), 2U) << "none is missing from 4 on";
    if (round == 0) world.end(request.id(), msg::SUCCEEDED);
    if (round == 1) world.restart();
  }
}

class P17Repeats : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kSteps = 3 * Repeats::kWindow + 7;

  void SetUp() override {
    world_.submit(request_);
    for (std::uint32_t i = 0; i < kSteps; ++i) world_.jobs->on_run_step(1, i, step_bytes(request_.id(), i, "s"));
    world_.end(request_.id(), msg::SUCCEEDED);
    world_.forget_messages();
  }
  std::size_t sent() const { return world_.steps(request_.id()).size(); }
  void expect_each_once(std::uint32_t from) const {
    Indices expected;
    for (std::uint32_t i = from; i < kSteps; ++i) expected.push_back(i);
    EXPECT_EQ(world_.steps(request_.id()), expected);
  }

  World world_;
  msg::PlanRequest request_ = good_request();
};

TEST_F(P17Repeats, ALongAnswerGoesAWindowAtATime) {
  world_.query(request_.id());
  EXPECT_EQ(sent(), Repeats::kWindow);
  EXPECT_TRUE(world_.jobs->repeating());
  EXPECT_FALSE(world_.jobs->idle());
  world_.jobs->repeat();
  EXPECT_EQ(sent(), 2 * Repeats::kWindow);
  while (world_.jobs->repeating()) world_.jobs->repeat();
  expect_each_once(0);
  EXPECT_TRUE(world_.jobs->idle());
}

TEST_F(P17Repeats, QuestionsWhileTheAnswerIsUnderWayAreAnsweredByTheEventAlone) {
  for (int i = 0; i < 3; ++i) world_.query(request_.id());
  EXPECT_EQ(world_.events(request_.id()).size(), 3U);
  while (world_.jobs->repeating()) world_.jobs->repeat();
  expect_each_once(0);
  world_.forget_messages();
  world_.query(request_.id(), kSteps - 1);
  expect_each_once(kSteps - 1);
}

TEST_F(P17Repeats, WhatHasArrivedMeanwhileIsLeftOut) {
  world_.query(request_.id());
  world_.query(request_.id(), kSteps - 2);
  while (world_.jobs->repeating()) world_.jobs->repeat();
  EXPECT_LE(sent(), 2 * Repeats::kWindow);
  EXPECT_EQ(world_.steps(request_.id()).back(), kSteps - 1);
}

TEST_F(P17Repeats, NothingIsSentToAReaderThatDoesNotKeepUp) {
  world_.query(request_.id());
  world_.outbox.waiting[World::kClient] = {request_.id()};
  world_.query(request_.id(), 0, World::kOther);
  for (int i = 0; i < 10; ++i) world_.jobs->repeat();
  EXPECT_EQ(sent(), Repeats::kWindow);
  EXPECT_EQ(world_.steps(request_.id(), World::kOther).size(), kSteps) << "others have their answer";
  world_.outbox.waiting.clear();
  while (world_.jobs->repeating()) world_.jobs->repeat();
  expect_each_once(0);
}

TEST_F(P17Repeats, StepsThatWaitForTheReaderAreUnderWayToo) {
  world_.outbox.waiting[World::kClient] = {request_.id()};
  world_.query(request_.id());
  world_.outbox.waiting.clear();
  EXPECT_FALSE(world_.jobs->repeating());
  EXPECT_EQ(sent(), 0U);
  EXPECT_EQ(world_.events(request_.id()).size(), 1U) << "it may ask again";
  world_.outbox.waiting[World::kClient] = {msg::id_of("another request")};
  world_.query(request_.id());
  world_.outbox.waiting.clear();
  while (world_.jobs->repeating()) world_.jobs->repeat();
  expect_each_once(0);
}

TEST_F(P17Repeats, AJournalThatCannotBeReadEndsTheAnswerNotTheServer) {
  world_.query(request_.id());
  world_.journal.unreadable = true;
  world_.jobs->repeat();
  EXPECT_EQ(world_.complaints.size(), 1U);
  world_.jobs->repeat();
  EXPECT_EQ(world_.complaints.size(), 1U);
  EXPECT_FALSE(world_.jobs->repeating());
}

TEST(P18, AQueryOfAnUnknownIdIsAnsweredUnknown) {
  World world;
  world.query(msg::id_of("unheard of"));
  EXPECT_EQ(world.last(msg::id_of("unheard of")).state(), msg::UNKNOWN);
  EXPECT_EQ(world.last(msg::id_of("unheard of")).error().code(), msg::UNKNOWN_REQUEST);
  EXPECT_TRUE(world.last(msg::id_of("unheard of")).answer());
}

TEST(P17, TheScenesShapesComeWithRunningAndWithAnswersFromStepZeroOn) {
  World world;
  auto request = good_request();
  request.shapes(true);
  world.submit(request);
  EXPECT_TRUE(world.events(request.id()).empty()) << "the scene is not prepared yet";
  world.jobs->on_run_scene(1, {box("floor")});
  world.jobs->settle();
  ASSERT_EQ(world.last(request.id()).state(), msg::RUNNING);
  ASSERT_EQ(world.last(request.id()).scene().size(), 1U);
  world.step(request.id(), 0);
  world.end(request.id(), msg::SUCCEEDED);
  EXPECT_TRUE(world.last(request.id()).scene().empty());
  world.query(request.id(), 0);
  EXPECT_EQ(world.last(request.id()).scene().size(), 1U);
  world.query(request.id(), 1);
  EXPECT_TRUE(world.last(request.id()).scene().empty());
  EXPECT_EQ(world.events(request.id()).size(), 4U);
}

TEST(P17, WithoutShapesOfTheSceneRunningIsToldWithTheFirstStep) {
  World world;
  auto first = good_request("first");
  auto second = good_request("second");
  first.shapes(true);
  second.shapes(true);
  world.submit(first);
  world.submit(second);
  world.step(first.id(), 0);
  EXPECT_EQ(world.state(first.id()), msg::RUNNING);
  world.end(second.id(), msg::FAILED, msg::INVALID_SCENE);
  ASSERT_EQ(world.events(second.id()).size(), 1U) << "it ended before it was told to run";
  EXPECT_EQ(world.events(second.id()).front().state(), msg::FAILED);
}

TEST(P28, ThePlanNamesTheRevisionItWasMadeForThoughANewerCame) {
  World world;
  auto request = good_request();
  request.scene("yard");
  world.submit(request);
  world.shelf.scenes.push_back({"yard", std::string(64, 'c'), "yaml", "/state/c.yaml", 12, 3});
  world.end(request.id(), msg::SUCCEEDED);
  EXPECT_EQ(world.last(request.id()).summary().scene_revision(), std::string(64, 'b'));
  EXPECT_EQ(world.planners.runs.at(1).scene->path, "/state/b.yaml");
  auto old = good_request("for the old one");
  old.scene("yard");
  old.scene_revision(std::string(64, 'a'));
  world.submit(old);
  EXPECT_EQ(world.planners.runs.at(2).scene->path, "/state/a.yaml");
}

TEST(P28, TheSummarySaysWhatGivesThePlanAgain) {
  World world;
  for (const char* name : {"r1", "r2"}) world.submit(good_request(name));
  auto request = good_request();
  msg::Parameter cycles;
  cycles.name("cycles");
  cycles.value("12");
  request.parameters({cycles});
  world.submit(request);
  world.wait(2.5);
  world.end(msg::id_of("r1"), msg::SUCCEEDED);
  world.end(request.id(), msg::SUCCEEDED);
  const auto summary = world.last(request.id()).summary();
  EXPECT_EQ(summary.robot(), "walker");
  EXPECT_EQ(summary.plugin(), "plugin of walker");
  EXPECT_EQ(summary.plugin_version(), "1.2.3");
  EXPECT_EQ(summary.server_version(), "0.1.0");
  EXPECT_EQ(summary.seed(), 42U);
  EXPECT_NEAR(summary.queued(), 2.5, 1e-9);
  EXPECT_EQ(summary.cost(), 1.5) << "what the worker says stays";
  ASSERT_EQ(summary.parameters().size(), 5U);
  EXPECT_EQ(summary.parameters()[0].value(), "12");
  EXPECT_EQ(summary.parameters()[1].value(), "0.5") << "the default";
}

}  // namespace
}  // namespace foothold::server::testing
