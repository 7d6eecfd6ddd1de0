// Cancels between real processes, with the clock: P10, P11, P12.
#include <algorithm>
#include <cstdio>
#include <thread>

#include "daemon.hpp"
#include "planners.hpp"
#include "vendor_pairs.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

using namespace std::chrono_literals;

class Cancels : public testing::TestWithParam<VendorPair> {
 protected:
  // From the cancel's writing to the final event's arrival, in seconds, sorted; every request must have sent a step before.
  static std::vector<double> measure(Wire& wire, const std::string& robot, int count, const msg::PlanRequest& like) {
    std::vector<double> took;
    for (int i = 0; i < count; ++i) {
      msg::PlanRequest request = like;
      request.id(msg::random_id());
      const msg::Id id = wire.submit(request);
      EXPECT_TRUE(wire.wait_for_steps(id, 1)) << robot;
      std::this_thread::sleep_for(5ms);  // well inside its search
      const auto asked = SteadyClock::now();
      wire.cancel(id);
      const auto end = wire.final_event(id);
      if (!end) {
        ADD_FAILURE() << "no final event";
        return took;
      }
      EXPECT_EQ(end->message.state(), msg::CANCELLED) << describe(end->message);
      EXPECT_EQ(end->message.error().code(), msg::CANCELLED_BY_CLIENT);
      took.push_back(std::chrono::duration<double>(end->at - asked).count());
    }
    std::ranges::sort(took);
    std::printf("%s: %d cancels, p50 %.2f ms, longest %.2f ms\n", robot.c_str(), count, took[took.size() / 2] * 1e3,
                took.back() * 1e3);
    return took;
  }
};

TEST_P(Cancels, OfAPlannerThatHeedsEndsWithin50Milliseconds) {
  const DaemonOptions options{.vendor = GetParam().server, .domain = 12, .robots = {good_robot("good")}};
  Daemon daemon(options);
  Wire wire(GetParam().client, options.domain);
  ASSERT_TRUE(wire.connect("good"));
  const auto took = measure(wire, "good", 60, paced_request("good", 100000, 0.002));
  ASSERT_EQ(took.size(), 60u);
  EXPECT_LE(took[30], 0.050);
  EXPECT_LE(took.back(), 1.0);  // one of them may meet a machine that is busy with something else
}

TEST_P(Cancels, OfAPlannerThatDoesNotHeedEndsAfterTheGraceTime) {
  constexpr double kGrace = 0.15;
  const DaemonOptions options{
      .vendor = GetParam().server, .domain = 12, .robots = {bad_robot("ignore")}, .grace = kGrace, .more = kNeverQuarantine};
  Daemon daemon(options);
  Wire wire(GetParam().client, options.domain);
  ASSERT_TRUE(wire.connect("ignore"));
  const auto took = measure(wire, "ignore", 12, request_for("ignore"));
  ASSERT_EQ(took.size(), 12u);
  EXPECT_GE(took.front(), kGrace * 0.99) << "killed before its grace was over";
  EXPECT_LE(took[6], kGrace + 0.050);
  EXPECT_LE(took.back(), kGrace + 1.0);
}

// P11, P10 and P12 on a hundred requests: each is cancelled before it is sent, while it runs or after it ended, and once more.
TEST_P(Cancels, EarlyLateAndTwiceAreAnsweredAsWritten) {
  const DaemonOptions options{.vendor = GetParam().server, .domain = 12, .robots = {good_robot("good", 4)}};
  Daemon daemon(options);
  Wire wire(GetParam().client, options.domain);
  ASSERT_TRUE(wire.connect("good"));

  for (int i = 0; i < 34; ++i) {
    SCOPED_TRACE("early " + std::to_string(i));
    msg::PlanRequest request = paced_request("good", 100000, 0.002);
    wire.cancel(request.id());
    ASSERT_TRUE(wire.wait_until(10.0, [&] { return !wire.events(request.id()).empty(); }));
    const msg::PlanEvent first = wire.events(request.id()).front().message;
    EXPECT_EQ(first.state(), msg::UNKNOWN);
    EXPECT_TRUE(first.answer());
    EXPECT_EQ(first.error().code(), msg::UNKNOWN_REQUEST);
    wire.submit(request);
    const auto end = wire.final_event(request.id());
    ASSERT_TRUE(end);
    EXPECT_EQ(end->message.state(), msg::CANCELLED) << describe(end->message);
    EXPECT_EQ(end->message.steps(), 0u);
    EXPECT_TRUE(wire.steps(request.id()).empty());
  }

  for (int i = 0; i < 33; ++i) {
    SCOPED_TRACE("late " + std::to_string(i));
    const msg::Id id = wire.submit(paced_request("good", 3, 0.0));
    const auto end = wire.final_event(id);
    ASSERT_TRUE(end);
    ASSERT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
    const std::size_t before = wire.events(id).size();
    wire.cancel(id);
    wire.cancel(id);
    ASSERT_TRUE(wire.wait_until(10.0, [&] { return wire.events(id).size() == before + 2; }));
    for (std::size_t k = before; k < before + 2; ++k) {
      const msg::PlanEvent answer = wire.events(id)[k].message;
      EXPECT_TRUE(answer.answer());
      EXPECT_EQ(answer.state(), msg::SUCCEEDED);
      EXPECT_EQ(answer.steps(), 3u);
      EXPECT_EQ(answer.stamp(), end->message.stamp());
    }
  }

  for (int i = 0; i < 33; ++i) {
    SCOPED_TRACE("twice " + std::to_string(i));
    const msg::Id id = wire.submit(paced_request("good", 100000, 0.002));
    ASSERT_TRUE(wire.wait_for_steps(id, 1));
    wire.cancel(id);
    wire.cancel(id);
    // One change to CANCELLED, and one answer to the second cancel: while it is being stopped or with its final event.
    const auto answers = [&] { return std::ranges::count_if(wire.events(id), [](const auto& e) { return e.message.answer(); }); };
    ASSERT_TRUE(wire.final_event(id));
    ASSERT_TRUE(wire.wait_until(10.0, [&] { return answers() == 1; }));
    const auto events = wire.events(id);
    EXPECT_EQ(std::ranges::count_if(events, [](const auto& e) { return is_final(e.message.state()) && !e.message.answer(); }), 1);
    const auto end = std::ranges::find_if(events, [](const auto& e) { return is_final(e.message.state()); });
    EXPECT_EQ(end->message.state(), msg::CANCELLED);
    ASSERT_TRUE(wire.wait_for_steps(id, end->message.steps()));
    EXPECT_EQ(wire.steps(id).size(), end->message.steps());
  }
  EXPECT_EQ(daemon.stop(), 0);
}

INSTANTIATE_TEST_SUITE_P(Pairs, Cancels, testing::ValuesIn(kVendorPairs), pair_name);

}  // namespace
}  // namespace foothold::test
