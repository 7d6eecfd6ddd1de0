// kill -9 of a worker, of the server, of a client, in the middle of a plan: P2, P16, P19, P22, P24.
#include <signal.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <thread>

#include "child.hpp"
#include "daemon.hpp"
#include "foothold/msg/cdr.hpp"
#include "planners.hpp"
#include "vendor_pairs.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

using namespace std::chrono_literals;

class Kills : public testing::TestWithParam<VendorPair> {
 protected:
  DaemonOptions options_{
      .vendor = GetParam().server, .domain = 13, .robots = {good_robot("good"), good_robot("other")}, .more = kNeverQuarantine};

  std::vector<std::string> lone_client(const msg::Id& id, std::uint32_t steps, double pause) const {
    return {FOOTHOLD_LONE_CLIENT,  GetParam().client,    std::to_string(options_.domain), msg::to_hex(id), "good",
            std::to_string(steps), std::to_string(pause)};
  }
};

// The steps 0 .. count - 1, each once.
void expect_steps(const std::vector<Arrival<msg::Step>>& steps, std::size_t count) {
  std::set<std::uint32_t> indices;
  for (const auto& step : steps) EXPECT_TRUE(indices.insert(step.message.index()).second) << "step " << step.message.index();
  EXPECT_EQ(indices.size(), count);
  EXPECT_TRUE(indices.empty() || *indices.rbegin() == count - 1);
}

TEST_P(Kills, OfAWorkerEndsItsOneRequest) {
  Daemon daemon(options_);
  Wire wire(GetParam().client, options_.domain);
  ASSERT_TRUE(wire.connect("good"));
  ASSERT_TRUE(wire.connect("other"));
  const std::vector<pid_t> workers = daemon.workers();
  ASSERT_EQ(workers.size(), 2u);

  const msg::Id a = wire.submit(paced_request("good", 100, 0.01));
  const msg::Id b = wire.submit(paced_request("other", 100, 0.01));
  ASSERT_TRUE(wire.wait_for_steps(a, 10));
  ASSERT_TRUE(wire.wait_for_steps(b, 10));
  ASSERT_EQ(::kill(workers.front(), SIGKILL), 0);
  const auto end_a = wire.final_event(a), end_b = wire.final_event(b);
  ASSERT_TRUE(end_a && end_b);
  const bool a_was_hit = end_a->message.state() != msg::SUCCEEDED;
  const auto& hit = a_was_hit ? end_a : end_b;
  const auto& missed = a_was_hit ? end_b : end_a;
  EXPECT_EQ(hit->message.state(), msg::CRASHED) << describe(hit->message);
  EXPECT_EQ(hit->message.error().code(), msg::WORKER_CRASHED) << describe(hit->message);
  EXPECT_NE(hit->message.error().message().find("SIGKILL"), std::string::npos) << describe(hit->message);
  EXPECT_EQ(missed->message.state(), msg::SUCCEEDED) << describe(missed->message);
  for (const auto& end : {end_a, end_b}) {
    ASSERT_TRUE(wire.wait_for_steps(end->message.request(), end->message.steps()));
    expect_steps(wire.steps(end->message.request()), end->message.steps());
  }
  EXPECT_GE(hit->message.steps(), 10u);

  // Another worker takes the place of the dead one.
  const msg::Id again = wire.submit(paced_request(a_was_hit ? "good" : "other", 5, 0.0));
  const auto end = wire.final_event(again);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
}

TEST_P(Kills, OfTheServerLosesNothingThatWasSent) {
  Daemon daemon(options_);
  Wire wire(GetParam().client, options_.domain);
  ASSERT_TRUE(wire.connect("good"));
  const msg::Id server = wire.server()->key();
  const std::vector<pid_t> workers = daemon.workers();

  const msg::Id finished = wire.submit(paced_request("good", 7, 0.0));
  ASSERT_TRUE(wire.final_event(finished));
  const msg::Id running = wire.submit(paced_request("good", 100000, 0.002));
  ASSERT_TRUE(wire.wait_for_steps(running, 30));
  const msg::Id waiting = wire.submit(paced_request("good", 7, 0.0));
  ASSERT_TRUE(wire.wait_until(10.0, [&] { return !wire.events(waiting).empty(); }));
  EXPECT_EQ(wire.events(waiting).front().message.state(), msg::QUEUED);
  daemon.kill();

  // A worker without a daemon ends by itself.
  const auto alive = [](pid_t pid) { return ::kill(pid, 0) == 0; };
  EXPECT_TRUE(wire.wait_until(5.0, [&] { return std::ranges::none_of(workers, alive); }));
  const std::size_t seen = wire.steps(running).size();

  daemon.start();
  Wire after(GetParam().client, options_.domain);
  ASSERT_TRUE(after.connect("good"));
  EXPECT_EQ(after.server()->key(), server);
  for (const msg::Id& id : {finished, running, waiting}) after.query(id);

  const auto first = after.final_event(finished);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->message.state(), msg::SUCCEEDED);
  EXPECT_TRUE(after.wait_for_steps(finished, 7));

  const auto second = after.final_event(running);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->message.state(), msg::FAILED) << describe(second->message);
  EXPECT_EQ(second->message.error().code(), msg::SERVER_RESTARTED);
  EXPECT_GE(second->message.steps(), seen) << "a step was sent that the journal does not hold";
  ASSERT_TRUE(after.wait_for_steps(running, second->message.steps()));
  expect_steps(after.steps(running), second->message.steps());
  for (const auto& before : wire.steps(running)) {
    const auto steps = after.steps(running);
    const auto same = std::ranges::find_if(steps, [&](const auto& s) { return s.message.index() == before.message.index(); });
    ASSERT_NE(same, steps.end());
    EXPECT_EQ(msg::encode(same->message), msg::encode(before.message));
  }

  const auto third = after.final_event(waiting);
  ASSERT_TRUE(third);
  EXPECT_EQ(third->message.state(), msg::FAILED) << describe(third->message);
  EXPECT_EQ(third->message.error().code(), msg::SERVER_RESTARTED);
  EXPECT_EQ(third->message.steps(), 0u);
}

TEST_P(Kills, OfTheServerRunsAgainWhatAskedForIt) {
  Daemon daemon(options_);
  Wire wire(GetParam().client, options_.domain);
  ASSERT_TRUE(wire.connect("good"));
  msg::PlanRequest lasting = paced_request("good", 400, 0.005);
  lasting.resume(true);
  wire.submit(lasting);
  msg::PlanRequest expiring = paced_request("other", 100000, 0.005);
  expiring.resume(true);
  expiring.budget(1.0);
  wire.submit(expiring);
  ASSERT_TRUE(wire.wait_for_steps(lasting.id(), 20));
  ASSERT_TRUE(wire.wait_for_steps(expiring.id(), 1));
  daemon.kill();
  std::this_thread::sleep_for(1s);

  daemon.start();
  Wire after(GetParam().client, options_.domain);
  ASSERT_TRUE(after.connect("good"));
  after.query(lasting.id());
  after.query(expiring.id());
  const auto past = after.final_event(expiring.id());
  ASSERT_TRUE(past);
  EXPECT_EQ(past->message.state(), msg::EXPIRED) << describe(past->message);
  // The one who asked first hears of it as well: his partition is the request's.
  ASSERT_TRUE(wire.wait_until(30.0, [&] {
    return std::ranges::any_of(wire.events(lasting.id()), [](const auto& e) { return is_final(e.message.state()); });
  }));
  const auto end = wire.final_event(lasting.id());
  EXPECT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
  EXPECT_EQ(end->message.steps(), 400u);
  EXPECT_TRUE(wire.wait_for_steps(lasting.id(), 400));
}

TEST_P(Kills, OfAClientChangesNothing) {
  Daemon daemon(options_);
  Wire observer(GetParam().client, options_.domain, "*");
  ASSERT_TRUE(observer.connect("good"));
  const msg::Id id = msg::random_id();
  {
    Child lone(lone_client(id, 200, 0.01));
    ASSERT_TRUE(observer.wait_for_steps(id, 20));
    lone.signal(SIGKILL);
  }
  const auto end = observer.final_event(id);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
  Wire later(GetParam().client, options_.domain);
  ASSERT_TRUE(later.connect("good"));
  later.query(id);
  const auto answer = later.final_event(id);
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->message.answer());
  EXPECT_EQ(answer->message.state(), msg::SUCCEEDED);
  ASSERT_TRUE(later.wait_for_steps(id, 200));
  expect_steps(later.steps(id), 200);
  EXPECT_EQ(daemon.stop(), 0);
}

// P25: what a halted client does not acknowledge stops neither the server nor another client, and the halted one gets all of its
// plan when it goes on. P17: what it asks for then is sent to it once, not with each of its questions.
TEST_P(Kills, AHaltedClientHoldsUpNobodyAndRepairsItself) {
  Daemon daemon(options_);
  Wire wire(GetParam().client, options_.domain);
  ASSERT_TRUE(wire.connect("good"));
  ASSERT_TRUE(wire.connect("other"));
  const msg::Id id = msg::random_id();
  constexpr std::uint32_t kSteps = 30000;  // more than a writer's history and its partition's queue hold
  Child lone(lone_client(id, kSteps, 0.0));
  ASSERT_TRUE(wire.wait_until(20.0, [&] {
    wire.query(id, kSteps);
    return !wire.events(id).empty() && wire.events(id).back().message.state() == msg::RUNNING;
  }));
  lone.signal(SIGSTOP);
  const auto asked = SteadyClock::now();
  const msg::Id other = wire.submit(paced_request("other", 200, 0.0));
  const auto end = wire.final_event(other, 10.0);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
  std::printf("beside a halted client: %.1f ms\n", std::chrono::duration<double>(end->at - asked).count() * 1e3);
  EXPECT_TRUE(wire.wait_until(30.0, [&] {
    wire.query(id, kSteps);
    return wire.events(id).back().message.state() == msg::SUCCEEDED;
  })) << "the halted client holds up its own plan";
  Wire observer(GetParam().client, options_.domain, "*");
  ASSERT_TRUE(observer.connect("good"));
  lone.signal(SIGCONT);
  EXPECT_EQ(lone.wait(60.0), static_cast<int>(msg::SUCCEEDED));
  std::map<std::uint32_t, std::size_t> times;
  for (const auto& step : observer.steps(id)) ++times[step.message.index()];
  std::size_t repeated = 0;
  for (const auto& [index, count] : times) repeated += count - 1;
  EXPECT_LE(repeated, 2048u) << "a few windows";
  std::printf("after it went on: %zu steps over the wire, %zu of them again\n", observer.steps(id).size(), repeated);
  EXPECT_EQ(daemon.stop(), 0);
}

// Longer than a second or three, as on a starved machine: the two ends find each other as they were.
TEST_P(Kills, HaltsOfSecondsEndWithEveryPlanWhole) {
  Daemon daemon(options_);
  Wire wire(GetParam().client, options_.domain);
  ASSERT_TRUE(wire.connect("good"));
  std::vector<std::unique_ptr<Child>> clients;
  for (int i = 0; i < 6; ++i) clients.push_back(std::make_unique<Child>(lone_client(msg::random_id(), 400, 0.0025)));
  std::this_thread::sleep_for(2s);
  daemon.signal(SIGSTOP);
  std::this_thread::sleep_for(5s);
  daemon.signal(SIGCONT);
  std::this_thread::sleep_for(1s);
  for (const auto& client : clients) client->signal(SIGSTOP);
  std::this_thread::sleep_for(5s);
  for (const auto& client : clients) client->signal(SIGCONT);
  for (const auto& client : clients) EXPECT_EQ(client->wait(15.0), static_cast<int>(msg::SUCCEEDED));
  EXPECT_EQ(daemon.stop(), 0);
}

INSTANTIATE_TEST_SUITE_P(Pairs, Kills, testing::ValuesIn(kVendorPairs), pair_name);

}  // namespace
}  // namespace foothold::test
