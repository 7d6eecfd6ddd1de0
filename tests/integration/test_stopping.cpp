// SIGTERM to a server with work: P23.
#include "daemon.hpp"
#include "planners.hpp"
#include "vendor_pairs.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

class Stopping : public testing::TestWithParam<VendorPair> {};

TEST_P(Stopping, EndsWhatRunsAndWhatWaitsAndSaysSo) {
  const DaemonOptions options{.vendor = GetParam().server, .domain = 15, .robots = {good_robot("good"), bad_robot("ignore")}};
  Daemon daemon(options);
  Wire wire(GetParam().client, options.domain);
  ASSERT_TRUE(wire.connect("good"));
  ASSERT_TRUE(wire.connect("ignore"));
  const msg::Id heeds = wire.submit(paced_request("good", 100000, 0.002));
  const msg::Id waits = wire.submit(paced_request("good", 100000, 0.002));
  const msg::Id ignores = wire.submit(request_for("ignore"));
  ASSERT_TRUE(wire.wait_for_steps(heeds, 10));
  ASSERT_TRUE(wire.wait_until(10.0, [&] { return !wire.events(waits).empty() && !wire.events(ignores).empty(); }));

  EXPECT_EQ(daemon.stop(10.0), 0);
  for (const msg::Id& id : {heeds, waits, ignores}) {
    const auto end = wire.final_event(id);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->message.state(), msg::CANCELLED) << describe(end->message);
    EXPECT_EQ(end->message.error().code(), msg::SERVER_STOPPING) << describe(end->message);
    EXPECT_TRUE(wire.wait_for_steps(id, end->message.steps()));
  }

  // What was said is what the journal holds.
  daemon.start();
  Wire after(GetParam().client, options.domain);
  ASSERT_TRUE(after.connect("good"));
  after.query(heeds);
  const auto end = after.final_event(heeds);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->message.state(), msg::CANCELLED);
  EXPECT_EQ(end->message.steps(), wire.final_event(heeds)->message.steps());
  EXPECT_EQ(daemon.stop(), 0);
}

INSTANTIATE_TEST_SUITE_P(Pairs, Stopping, testing::ValuesIn(kVendorPairs), pair_name);

}  // namespace
}  // namespace foothold::test
