// More than one server: what becomes of a request whose server is lost or cannot take it. P34 to P38.
#include <gtest/gtest.h>

#include <algorithm>

#include "eventually.hpp"
#include "foothold/client/client.hpp"
#include "foothold/msg/errors.hpp"
#include "scripted_server.hpp"

namespace foothold::test {
namespace {

using client::Client;
using client::Plan;
using client::PlanCallbacks;
using Script = ScriptedServer::Script;

constexpr double kSoon = 20.0;  // s; a limit for a stuck test, never a measure

// Two servers of one robot, and a client that sees both.
class Failover : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(connect(client_)); }

  bool connect(Client& client) {
    return eventually([&] { return client.servers().size() == 2 && client.robots().size() == 2; }) &&
           client.wait_for_server(kSoon, a_.id()) && client.wait_for_server(kSoon, b_.id());
  }

  static msg::PlanRequest request() {
    msg::PlanRequest request;
    request.robot("robot");
    request.unit("unit 7");
    request.budget(5.0);
    return request;
  }

  void submit(const msg::PlanRequest& request) {
    PlanCallbacks callbacks;
    callbacks.on_server = [&](bool gone) { note(gone ? "lost" : "back"); };
    callbacks.on_event = [&](const msg::PlanEvent& event) { note(msg::state_name(event.state())); };
    callbacks.on_step = [&](const msg::Step& step) { note(std::to_string(step.index())); };
    plan_.emplace(client_.submit(request, callbacks));
  }
  // The server that has the plan now, and the other.
  ScriptedServer& its() { return plan_->server() == a_.id() ? a_ : b_; }
  ScriptedServer& other() { return plan_->server() == a_.id() ? b_ : a_; }

  // What this server was asked for.
  static std::vector<msg::PlanRequest> asked(const ScriptedServer& server) {
    auto requests = server.requests();
    std::erase_if(requests, [&](const msg::PlanRequest& request) { return request.server() != server.id(); });
    return requests;
  }

  void note(std::string_view word) {
    const std::lock_guard lock(mutex_);
    told_ += (told_.empty() ? "" : " ") + std::string(word);
  }
  std::string told() {
    const std::lock_guard lock(mutex_);
    return told_;
  }
  bool steps_arrive(std::size_t count) {
    return eventually([&] { return plan_->steps_ready() >= count; });
  }

  // Has four steps and no end; its server falls silent, the other does as `script` says. Gives the one that is silent.
  ScriptedServer& lose_its_server(const Script& script) {
    submit(request());
    EXPECT_TRUE(steps_arrive(4));
    ScriptedServer& lost = its();
    other().set_script(script);
    lost.fall_silent(true);
    return lost;
  }

  MemoryNetwork network_;
  ScriptedServer a_{network_, {.steps = 4, .ends = false}, msg::id_of("one")};
  ScriptedServer b_{network_, {.steps = 4, .ends = false}, msg::id_of("two")};
  std::mutex mutex_;
  std::string told_;
  Client client_{network_.bus(), {.repair_after = 0.02, .server_silence = 0.4}};
  std::optional<Plan> plan_;
};

TEST_F(Failover, ARequestWhoseServerIsLostGoesToAnotherUnderItsId) {
  ScriptedServer& lost = lose_its_server({.steps = 7});
  const auto end = plan_->wait(kSoon);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->state(), msg::SUCCEEDED);
  EXPECT_NE(plan_->server(), lost.id());
  EXPECT_EQ(end->server(), plan_->server());
  EXPECT_EQ(plan_->traffic().moves, 1u);
  ASSERT_TRUE(eventually([&] { return told().ends_with("SUCCEEDED"); }));
  EXPECT_EQ(told(), "RUNNING 0 1 2 3 lost back RUNNING 4 5 6 SUCCEEDED") << "each step once, in order";
  ASSERT_FALSE(asked(its()).empty());
  msg::PlanRequest second = asked(its()).front();
  second.server(lost.id());
  EXPECT_EQ(second, asked(lost).front()) << "the same request but for whom it is for";
}

TEST_F(Failover, StepsThatAreNotTheSameEndThePlanWithWhatArrivedBefore) {
  lose_its_server({.steps = 7, .other_from = 2});
  const auto end = plan_->wait(kSoon);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->state(), msg::FAILED);
  EXPECT_EQ(end->error().code(), msg::PLAN_DIFFERS);
  EXPECT_NE(end->error().message().find("step 2 is not"), std::string::npos) << end->error().message();
  EXPECT_TRUE(end->error().retryable());
  EXPECT_EQ(end->steps(), 4u);
  EXPECT_EQ(end->unit(), "unit 7");
  EXPECT_EQ(plan_->record().steps.size(), 4u);
  ScriptedServer& its_server = its();
  EXPECT_TRUE(eventually([&] { return its_server.cancels().size() == 1; })) << "nobody wants that plan any more";
}

TEST_F(Failover, StepsThatDifferOnlyAfterThoseThatArrivedAreGoneOnWith) {
  lose_its_server({.steps = 7, .other_from = 4});
  const auto end = plan_->wait(kSoon);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->state(), msg::SUCCEEDED);
  EXPECT_EQ(plan_->record().steps.back().label(), "another");
}

TEST_F(Failover, AShorterPlanIsAnother) {
  lose_its_server({.steps = 3});
  const auto end = plan_->wait(kSoon);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->error().code(), msg::PLAN_DIFFERS);
  EXPECT_EQ(end->steps(), 4u);
}

TEST_F(Failover, AFailureOfTheSecondServerLeavesTheStepsOfTheFirst) {
  lose_its_server({.fail = msg::NO_PATH});
  const auto end = plan_->wait(kSoon);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->state(), msg::FAILED);
  EXPECT_EQ(end->error().code(), msg::NO_PATH);
  EXPECT_EQ(end->steps(), 4u) << "as many as there are";
  EXPECT_EQ(plan_->record().steps.size(), 4u);
}

TEST_F(Failover, AnEndWhoseStepsDidNotComeIsMadeAnewToo) {
  for (ScriptedServer* server : {&a_, &b_}) server->set_script({.steps = 5});
  network_.set_faults(transport::Topic::kStep, {.loss = 1.0});
  submit(request());
  ASSERT_TRUE(eventually([&] { return plan_->state() == msg::SUCCEEDED; }));
  EXPECT_FALSE(plan_->ended());
  other().set_script({.fail = msg::NO_PATH});
  its().fall_silent(true);
  ASSERT_TRUE(network_.settle());
  network_.set_faults(transport::Topic::kStep, {});
  const auto end = plan_->wait(kSoon);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->error().code(), msg::NO_PATH);
}

TEST_F(Failover, WhatTheFirstServerSaysAfterwardsChangesNothingAndItIsTold) {
  ScriptedServer& lost = lose_its_server({.steps = 4, .ends = false});
  ASSERT_TRUE(eventually([&] { return plan_->server() != lost.id() && plan_->state() == msg::RUNNING; }));
  const msg::Id second = plan_->server();
  // As if only its heartbeats had been lost: it had gone on.
  for (std::uint32_t i = 4; i < 9; ++i) lost.send(client_.id(), numbered_step(plan_->id(), i, lost.id()));
  msg::PlanEvent late;
  late.request(plan_->id());
  late.server(lost.id());
  late.state(msg::SUCCEEDED);
  late.steps(9);
  lost.send(client_.id(), late);
  ASSERT_TRUE(network_.settle());
  lost.fall_silent(false);
  const auto told_it = [&] {
    return std::ranges::any_of(lost.requests(), [&](const auto& r) { return r.id() == plan_->id() && r.server() == second; });
  };
  EXPECT_TRUE(eventually(told_it)) << "that the request is another's now";
  EXPECT_FALSE(plan_->ended());
  EXPECT_EQ(plan_->steps_ready(), 4u);
  plan_->cancel("enough");
  const auto end = plan_->wait(kSoon);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->state(), msg::CANCELLED);
  EXPECT_EQ(end->server(), second);
}

TEST_F(Failover, WhoCannotTakeItPassesItOn) {
  for (const std::uint16_t code : {msg::QUEUE_FULL, msg::SERVER_STOPPING, msg::ROBOT_QUARANTINED, msg::UNKNOWN_SCENE}) {
    SCOPED_TRACE(code);
    for (ScriptedServer* server : {&a_, &b_}) server->set_script({.refuse = code});
    submit(request());
    auto end = plan_->wait(kSoon);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->state(), msg::REJECTED) << "nobody can";
    EXPECT_EQ(end->error().code(), code);
    EXPECT_EQ(plan_->traffic().moves, 1u);
    for (ScriptedServer* able : {&a_, &b_}) {
      a_.set_script({.refuse = code});
      b_.set_script({.refuse = code});
      able->set_script({.steps = 3});
      submit(request());
      end = plan_->wait(kSoon);
      ASSERT_TRUE(end);
      EXPECT_EQ(end->state(), msg::SUCCEEDED);
      EXPECT_EQ(plan_->server(), able->id());
    }
  }
}

TEST_F(Failover, WhatIsTheRequestsOwnFaultIsNotPassedOn) {
  for (ScriptedServer* server : {&a_, &b_}) server->set_script({.refuse = msg::NOT_FINITE});
  submit(request());
  auto end = plan_->wait(kSoon);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->error().code(), msg::NOT_FINITE);
  EXPECT_EQ(plan_->traffic().moves, 0u);
  for (ScriptedServer* server : {&a_, &b_}) server->set_script({.fail = msg::WORKER_CRASHED});
  submit(request());
  end = plan_->wait(kSoon);
  ASSERT_TRUE(end);
  EXPECT_EQ(plan_->traffic().moves, 0u) << "what crashes one planner may crash the next";
}

TEST_F(Failover, WhatTheCallerAddressedStaysThere) {
  auto addressed = request();
  addressed.server(a_.id());
  submit(addressed);
  ASSERT_TRUE(steps_arrive(4));
  a_.fall_silent(true);
  ASSERT_TRUE(eventually([&] { return plan_->server_lost(); }));
  ASSERT_TRUE(network_.settle());
  EXPECT_TRUE(asked(b_).empty());
  a_.fall_silent(false);
  ASSERT_TRUE(eventually([&] { return !plan_->server_lost(); }));
  EXPECT_EQ(plan_->traffic().moves, 0u);
}

TEST_F(Failover, AServerThatWasRestartedIsToldThatItIsStillCountedOn) {
  submit(request());
  ASSERT_TRUE(steps_arrive(4));
  msg::PlanEvent asks;
  asks.request(plan_->id());
  asks.server(its().id());
  asks.state(msg::QUEUED);
  asks.steps(4);
  asks.error(msg::make_error(msg::SERVER_RESTARTED, "is it still wanted?"));
  ScriptedServer& its_server = its();
  its_server.send(client_.id(), asks);
  ASSERT_TRUE(eventually([&] { return asked(its_server).size() == 2; }));
  EXPECT_EQ(asked(its_server)[0], asked(its_server)[1]);
}

TEST_F(Failover, WhoAsksForAMovedPlanHearsOfTheServerThatHasIt) {
  const msg::Id id = msg::random_id();
  for (ScriptedServer* first : {&a_, &b_}) {
    for (ScriptedServer* server : {&a_, &b_}) server->forget_everything();
    ScriptedServer& second = first == &a_ ? b_ : a_;
    first->set_script({.fail = msg::MOVED});
    second.set_script({.steps = 5});
    for (ScriptedServer* server : {first, &second}) {
      Client owner(network_.bus(), {.repair_after = 0.02, .server_silence = 60.0});
      ASSERT_TRUE(connect(owner));
      auto one = request();
      one.id(id);
      one.server(server->id());
      Plan made = owner.submit(one);
      ASSERT_TRUE(made.wait(kSoon));
    }
    Plan asked = client_.query(id);
    const auto end = asked.wait(kSoon);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->state(), msg::SUCCEEDED);
    EXPECT_EQ(end->server(), second.id());
    EXPECT_EQ(asked.record().steps.size(), 5u);
  }
}

TEST_F(Failover, IfNobodyElseKnowsItThenThatItMovedIsTheAnswer) {
  a_.set_script({.fail = msg::MOVED});
  auto one = request();
  one.server(a_.id());
  submit(one);
  ASSERT_TRUE(plan_->wait(kSoon));
  Client other(network_.bus(), {.repair_after = 0.02, .server_silence = 60.0});
  ASSERT_TRUE(connect(other));
  const auto end = other.query(plan_->id()).wait(kSoon);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->error().code(), msg::MOVED);
}

}  // namespace
}  // namespace foothold::test
