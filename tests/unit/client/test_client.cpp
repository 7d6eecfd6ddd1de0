// The client against a scripted server, on a network that keeps its promises.
#include <gtest/gtest.h>

#include <atomic>
#include <future>

#include "eventually.hpp"
#include "foothold/client/client.hpp"
#include "scripted_server.hpp"

namespace foothold::test {
namespace {

using client::Client;
using client::Plan;
using client::PlanCallbacks;

constexpr double kSoon = 10.0;  // s; a limit for a stuck test, never a measure

msg::PlanRequest request_for(const std::string& robot) {
  msg::PlanRequest request;
  request.robot(robot);
  request.budget(5.0);
  return request;
}

struct Pair {
  explicit Pair(ScriptedServer::Script script = {}) : server(network, std::move(script)), client(network.bus()) {
    EXPECT_TRUE(client.wait_for_server(kSoon));
  }
  MemoryNetwork network;
  ScriptedServer server;
  Client client;
};

TEST(Client, StreamsEveryStepInOrderAndEnds) {
  Pair pair({.steps = 100});
  Plan plan = pair.client.submit(request_for("robot"));
  std::uint32_t index = 0;
  for (const msg::Step& step : plan) EXPECT_EQ(step, numbered_step(plan.id(), index++));
  EXPECT_EQ(index, 100u);
  const auto final_event = plan.wait(kSoon);
  ASSERT_TRUE(final_event);
  EXPECT_EQ(final_event->state(), msg::SUCCEEDED);
  EXPECT_TRUE(plan.ended());
  EXPECT_EQ(plan.next(0.0), nullptr);
  EXPECT_EQ(plan.record().steps.size(), 100u);
}

TEST(Client, HoldsThePlanOpenUntilTheStepsThatTheFinalEventOvertookAreThere) {
  Pair pair;
  pair.network.set_faults(transport::Topic::kStep, {.stalled = true});
  pair.server.set_script({.steps = 5, .final_first = true});
  Plan plan = pair.client.submit(request_for("robot"));
  ASSERT_TRUE(eventually([&] { return plan.state() == msg::SUCCEEDED; }));
  EXPECT_FALSE(plan.ended());
  EXPECT_FALSE(plan.wait(0.0));
  pair.network.set_faults(transport::Topic::kStep, {});
  ASSERT_TRUE(plan.wait(kSoon));
  EXPECT_EQ(plan.steps_ready(), 5u);
}

TEST(Client, FillsInItsIdAndTheServerThatHasTheRobot) {
  MemoryNetwork network;
  ScriptedServer other(network, {.robot = "other"}, msg::id_of("one"));
  ScriptedServer server(network, {.robot = "robot"}, msg::id_of("two"));
  Client client(network.bus());
  ASSERT_TRUE(client.wait_for_robot("robot", kSoon));
  ASSERT_TRUE(client.submit(request_for("robot")).wait(kSoon));
  const auto requests = server.requests();
  ASSERT_EQ(requests.size(), 1u);
  EXPECT_EQ(requests[0].server(), server.id());
  EXPECT_EQ(requests[0].client(), client.id());
  EXPECT_NE(requests[0].id(), msg::kNoId);
}

TEST(Client, KeepsARequestUntilAServerIsThere) {
  MemoryNetwork network;
  Client client(network.bus());
  Plan plan = client.submit(request_for("robot"));
  EXPECT_EQ(plan.next(0.05), nullptr);
  EXPECT_FALSE(plan.ended());
  ScriptedServer server(network, {});
  ASSERT_TRUE(plan.wait(kSoon));
  EXPECT_EQ(plan.steps_ready(), 10u);
}

TEST(Client, SendsAnUnansweredRequestAgainUnderTheSameId) {
  MemoryNetwork network;
  ScriptedServer server(network, {.deaf = true});
  Client client(network.bus(), {.resend_after = 0.02});
  ASSERT_TRUE(client.wait_for_robot("robot", kSoon));
  Plan plan = client.submit(request_for("robot"));
  ASSERT_TRUE(eventually([&] { return server.requests().size() >= 3; }));
  server.set_script({.steps = 3});
  ASSERT_TRUE(plan.wait(kSoon));
  EXPECT_GE(plan.traffic().requests, 3u);
  for (const auto& request : server.requests()) EXPECT_EQ(request.id(), plan.id());
}

TEST(Client, CallbacksComeInOrderAndTheFinalEventLast) {
  Pair pair({.steps = 50, .final_first = true});
  std::vector<std::string> told;
  std::promise<void> over;
  PlanCallbacks callbacks;
  callbacks.on_step = [&](const msg::Step& step) { told.push_back(std::to_string(step.index())); };
  callbacks.on_event = [&](const msg::PlanEvent& event) {
    told.emplace_back(msg::state_name(event.state()));
    if (msg::is_final(event.state())) over.set_value();
  };
  pair.client.submit(request_for("robot"), callbacks);
  ASSERT_EQ(over.get_future().wait_for(std::chrono::seconds(10)), std::future_status::ready);
  ASSERT_EQ(told.size(), 52u);
  EXPECT_EQ(told.front(), "RUNNING");
  for (std::size_t i = 0; i < 50; ++i) EXPECT_EQ(told[i + 1], std::to_string(i));
  EXPECT_EQ(told.back(), "SUCCEEDED");
}

TEST(Client, CancelsInsideACallback) {
  Pair pair({.steps = 3, .ends = false});
  std::atomic<int> steps = 0;
  std::promise<msg::State> over;
  std::optional<Plan> plan;
  std::promise<void> submitted;
  PlanCallbacks callbacks;
  callbacks.on_step = [&, ready = submitted.get_future().share()](const msg::Step& step) {
    ++steps;
    ready.wait();
    if (step.index() == 1) plan->cancel("seen enough");
  };
  callbacks.on_event = [&](const msg::PlanEvent& event) {
    if (msg::is_final(event.state())) over.set_value(event.state());
  };
  plan = pair.client.submit(request_for("robot"), callbacks);
  submitted.set_value();
  auto state = over.get_future();
  ASSERT_EQ(state.wait_for(std::chrono::seconds(10)), std::future_status::ready);
  EXPECT_EQ(state.get(), msg::CANCELLED);
  EXPECT_EQ(steps, 3);
  ASSERT_FALSE(pair.server.cancels().empty());
  EXPECT_EQ(pair.server.cancels()[0].reason(), "seen enough");
}

TEST(Client, SubmitsInsideACallback) {
  Pair pair({.steps = 2});
  std::promise<msg::Id> second;
  PlanCallbacks callbacks;
  callbacks.on_event = [&](const msg::PlanEvent& event) {
    if (msg::is_final(event.state())) second.set_value(pair.client.submit(request_for("robot")).id());
  };
  Plan first = pair.client.submit(request_for("robot"), callbacks);
  auto id = second.get_future();
  ASSERT_EQ(id.wait_for(std::chrono::seconds(10)), std::future_status::ready);
  EXPECT_NE(id.get(), first.id());
}

TEST(Client, FollowsAForeignRequestFromAStepOn) {
  Pair pair({.steps = 20});
  Plan plan = pair.client.submit(request_for("robot"));
  ASSERT_TRUE(plan.wait(kSoon));
  Client other(pair.network.bus());
  Plan seen = other.query(plan.id(), 15);
  ASSERT_TRUE(seen.wait(kSoon));
  const auto record = seen.record();
  ASSERT_EQ(record.steps.size(), 5u);
  EXPECT_EQ(record.steps.front().index(), 15u);
}

TEST(Client, EndsAQueryForAnUnknownIdInStateUnknown) {
  Pair pair;
  Plan plan = pair.client.query(msg::id_of("nobody asked for this"));
  const auto answer = plan.wait(kSoon);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->state(), msg::UNKNOWN);
}

TEST(Client, TheSameIdTwiceIsThePlanThatIsOpen) {
  Pair pair({.ends = false});
  msg::PlanRequest request = request_for("robot");
  request.id(msg::id_of("twice"));
  Plan first = pair.client.submit(request);
  Plan second = pair.client.submit(request);
  ASSERT_NE(first.next(kSoon), nullptr);
  ASSERT_NE(second.next(kSoon), nullptr);
  EXPECT_EQ(pair.server.requests().size(), 1u);
}

TEST(Client, AHandleOutlivesItsClient) {
  MemoryNetwork network;
  ScriptedServer server(network, {.ends = false});
  std::optional<Plan> plan;
  {
    Client client(network.bus());
    ASSERT_TRUE(client.wait_for_server(kSoon));
    plan = client.submit(request_for("robot"));
    ASSERT_NE(plan->next(kSoon), nullptr);
  }
  while (plan->next() != nullptr) {
  }
  EXPECT_FALSE(plan->wait());
  plan->cancel("nobody is there to send it");
}

TEST(Client, WritesThatMeetAFullHistoryAreSentLater) {
  Pair pair;
  pair.network.set_faults(transport::Topic::kRequest, {.full = true});
  Plan plan = pair.client.submit(request_for("robot"));
  EXPECT_EQ(plan.next(0.05), nullptr);
  pair.network.set_faults(transport::Topic::kRequest, {});
  ASSERT_TRUE(plan.wait(kSoon));
}

}  // namespace
}  // namespace foothold::test
