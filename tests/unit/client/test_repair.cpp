// The client on a network that loses, doubles and reorders, and with servers that vanish. P14, P17, P18.
#include <gtest/gtest.h>

#include <algorithm>
#include <future>
#include <random>

#include "eventually.hpp"
#include "foothold/client/client.hpp"
#include "foothold/msg/errors.hpp"
#include "scripted_server.hpp"

namespace foothold::test {
namespace {

using client::Client;
using client::Plan;
using client::PlanCallbacks;
using transport::Topic;

constexpr double kSoon = 20.0;  // s; a limit for a stuck test, never a measure

msg::PlanRequest request_for_robot() {
  msg::PlanRequest request;
  request.robot("robot");
  request.budget(5.0);
  return request;
}

class Repair : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Repair, EveryStepOnceAndInOrderWhateverIsLostDoubledOrReordered) {
  std::mt19937_64 random(GetParam());
  std::uniform_real_distribution<double> chance(0.0, 0.5);
  MemoryNetwork network(GetParam());
  ScriptedServer server(network, {});
  Client client(network.bus(), {.repair_after = 0.004, .resend_after = 0.01, .server_silence = 60.0});
  ASSERT_TRUE(client.wait_for_server(kSoon));
  ASSERT_TRUE(client.wait_for_robot("robot", kSoon));
  for (const Topic topic : {Topic::kRequest, Topic::kQuery, Topic::kEvent, Topic::kStep})
    network.set_faults(topic, {.loss = chance(random), .duplicate = chance(random), .reorder = chance(random)});
  for (int round = 0; round < 5; ++round) {
    const auto count = static_cast<std::uint32_t>(random() % 120);
    server.set_script({.steps = count, .final_first = random() % 2 == 0});
    std::vector<std::uint32_t> told;
    std::promise<void> over;
    PlanCallbacks callbacks;
    callbacks.on_step = [&](const msg::Step& step) { told.push_back(step.index()); };
    callbacks.on_event = [&](const msg::PlanEvent& event) {
      if (msg::is_final(event.state())) over.set_value();
    };
    Plan plan = client.submit(request_for_robot(), callbacks);
    ASSERT_TRUE(plan.wait(kSoon)) << "has " << plan.steps_ready() << " of " << count;
    ASSERT_EQ(over.get_future().wait_for(std::chrono::seconds(20)), std::future_status::ready);
    ASSERT_EQ(told.size(), count);
    for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(told[i], i);
    std::uint32_t index = 0;
    while (const msg::Step* step = plan.next(0.0)) ASSERT_EQ(*step, numbered_step(plan.id(), index++));
    ASSERT_EQ(index, count);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Repair, testing::Range<std::uint64_t>(1, 13));

TEST(Repairs, AFinalEventThatWasLostIsAskedFor) {
  MemoryNetwork network;
  ScriptedServer server(network, {.steps = 3});
  Client client(network.bus(), {.repair_after = 0.01});
  ASSERT_TRUE(client.wait_for_server(kSoon));
  network.set_faults(Topic::kEvent, {.loss = 1.0});
  Plan plan = client.submit(request_for_robot());
  ASSERT_TRUE(eventually([&] { return plan.steps_ready() >= 3; }));
  network.set_faults(Topic::kEvent, {});
  ASSERT_TRUE(plan.wait(kSoon));
  EXPECT_EQ(plan.record().final_event.state(), msg::SUCCEEDED);
  EXPECT_GE(plan.traffic().queries, 1u);
}

TEST(Repairs, AsksFromTheFirstStepThatIsMissing) {
  MemoryNetwork network;
  ScriptedServer server(network, {.deaf = true});
  Client client(network.bus(), {.repair_after = 0.01});
  ASSERT_TRUE(client.wait_for_server(kSoon));
  network.set_faults(Topic::kEvent, {.stalled = true});  // else the server's word that it knows nothing ends the plan
  Plan plan = client.query(msg::id_of("a plan of two thirds"));
  for (const std::uint32_t index : {0u, 1u, 4u, 5u}) server.send(client.id(), numbered_step(plan.id(), index));
  ASSERT_TRUE(eventually([&] { return plan.steps_ready() >= 2; }));
  const std::size_t before = server.queries().size();
  ASSERT_TRUE(eventually([&] { return server.queries().size() > before + 1; }));
  EXPECT_EQ(server.queries().back().from_step(), 2u);
}

TEST(Repairs, AnIdlePlanIsAskedForEverMoreRarely) {
  MemoryNetwork network;
  ScriptedServer server(network, {.steps = 0, .ends = false});
  Client client(network.bus(), {.repair_after = 0.02});
  ASSERT_TRUE(client.wait_for_server(kSoon));
  Plan plan = client.submit(request_for_robot());
  EXPECT_EQ(plan.next(1.0), nullptr);
  // Steadily it would be 50 in this second; doubled up to ten times the pause it is 3 and then one each 0.2 s.
  EXPECT_GE(plan.traffic().queries, 2u);
  EXPECT_LE(plan.traffic().queries, 12u);
}

TEST(Repairs, AQuestionWithoutAnAnswerIsRepeatedEverMoreRarely) {
  MemoryNetwork network;
  ScriptedServer server(network, {.deaf = true});
  Client client(network.bus(), {.repair_after = 0.02});
  ASSERT_TRUE(client.wait_for_server(kSoon));
  network.set_faults(Topic::kEvent, {.stalled = true});
  Plan plan = client.query(msg::id_of("a plan with a gap"));
  server.send(client.id(), numbered_step(plan.id(), 5));
  EXPECT_EQ(plan.next(1.0), nullptr);
  // Steadily it would be 50 in this second.
  EXPECT_GE(plan.traffic().queries, 2u);
  EXPECT_LE(plan.traffic().queries, 12u);
}

TEST(LostServer, OpenPlansAreToldAndGoOnWhenItIsBack) {
  MemoryNetwork network;
  ScriptedServer server(network, {.steps = 4, .ends = false});
  Client client(network.bus(), {.repair_after = 0.02, .server_silence = 0.4});
  ASSERT_TRUE(client.wait_for_server(kSoon));
  std::promise<void> lost, back;
  PlanCallbacks callbacks;
  callbacks.on_server = [&](bool gone) { (gone ? lost : back).set_value(); };
  Plan plan = client.submit(request_for_robot(), callbacks);
  ASSERT_TRUE(eventually([&] { return plan.steps_ready() >= 4; }));
  server.fall_silent(true);
  ASSERT_EQ(lost.get_future().wait_for(std::chrono::seconds(20)), std::future_status::ready);
  EXPECT_TRUE(plan.server_lost());
  EXPECT_FALSE(plan.ended());
  ASSERT_EQ(client.servers().size(), 1u);
  EXPECT_FALSE(client.servers()[0].alive);
  plan.cancel("while it is away");  // the silent server drops it
  ASSERT_TRUE(network.settle());
  server.fall_silent(false);
  ASSERT_EQ(back.get_future().wait_for(std::chrono::seconds(20)), std::future_status::ready);
  const auto end = plan.wait(kSoon);
  ASSERT_TRUE(end) << "the cancel was not sent again";
  EXPECT_EQ(end->state(), msg::CANCELLED);
}

TEST(LostServer, WhatItSaysProvesThatItIsBack) {
  MemoryNetwork network;
  ScriptedServer server(network, {.steps = 2, .ends = false});
  Client client(network.bus(), {.repair_after = 30.0, .server_silence = 0.4});
  ASSERT_TRUE(client.wait_for_server(kSoon));
  std::vector<std::string> told;
  std::promise<void> over;
  PlanCallbacks callbacks;
  callbacks.on_server = [&](bool gone) { told.emplace_back(gone ? "lost" : "back"); };
  callbacks.on_event = [&](const msg::PlanEvent& event) {
    told.emplace_back(msg::state_name(event.state()));
    if (msg::is_final(event.state())) over.set_value();
  };
  Plan plan = client.submit(request_for_robot(), callbacks);
  ASSERT_TRUE(eventually([&] { return plan.steps_ready() == 2; }));
  server.fall_silent(true);
  ASSERT_TRUE(eventually([&] { return plan.server_lost(); }));
  msg::PlanEvent end;
  end.request(plan.id());
  end.server(server.id());
  end.state(msg::FAILED);
  end.steps(2);
  server.send(client.id(), end);
  ASSERT_EQ(over.get_future().wait_for(std::chrono::seconds(20)), std::future_status::ready);
  EXPECT_EQ(told, (std::vector<std::string>{"RUNNING", "lost", "back", "FAILED"}));
}

TEST(LostServer, APlanThatItsServerForgotEndsUnknownAndIsNotPlannedAgain) {
  MemoryNetwork network;
  ScriptedServer server(network, {.steps = 4, .ends = false});
  Client client(network.bus(), {.repair_after = 0.01});
  ASSERT_TRUE(client.wait_for_server(kSoon));
  Plan plan = client.submit(request_for_robot());
  ASSERT_TRUE(eventually([&] { return plan.steps_ready() >= 4; }));
  server.forget_everything();
  const auto end = plan.wait(kSoon);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->state(), msg::UNKNOWN);
  EXPECT_EQ(server.requests().size(), 1u);
}

TEST(LostServer, AnotherServerThatDoesNotKnowARequestDoesNotEndIt) {
  MemoryNetwork network;
  ScriptedServer server(network, {.steps = 4, .ends = false}, msg::id_of("one"));
  ScriptedServer stranger(network, {.robot = "other"}, msg::id_of("two"));
  Client client(network.bus(), {.repair_after = 0.005});
  ASSERT_TRUE(client.wait_for_robot("robot", kSoon));
  ASSERT_TRUE(client.wait_for_robot("other", kSoon));
  Plan plan = client.submit(request_for_robot());
  ASSERT_TRUE(eventually([&] { return stranger.queries().size() >= 6; }));
  EXPECT_FALSE(plan.ended());
  plan.cancel("enough");
  ASSERT_TRUE(plan.wait(kSoon));
}

}  // namespace
}  // namespace foothold::test
