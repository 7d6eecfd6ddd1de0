// The octopod's planner in the real server, over DDS: the shipped requests, every step in order, refusals, no route.
#include <cmath>

#include "daemon.hpp"
#include "foothold/client/request_file.hpp"
#include "foothold/msg/errors.hpp"
#include "vendor_pairs.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

constexpr std::uint32_t kDomain = 23;

DaemonOptions options(const std::string& vendor) {
  return {.vendor = vendor,
          .domain = kDomain,
          .robots = {{.name = "octopod", .file = FOOTHOLD_CONFIG_DIR "/robots/octopod.yaml"}},
          .more = "scenes: {preload: [" FOOTHOLD_CONFIG_DIR "/scenes]}\n",
          .plugin_dir = FOOTHOLD_PLUGINS};
}

msg::PlanRequest shipped_request(const std::string& stem) {
  return client::read_request_file(FOOTHOLD_CONFIG_DIR "/requests/" + stem + ".yaml").request;
}

class Octopod : public testing::TestWithParam<VendorPair> {};

TEST_P(Octopod, StreamsThePapersRouteStepByStep) {
  Daemon daemon(options(GetParam().server));
  Wire wire(GetParam().client, kDomain);
  ASSERT_TRUE(wire.connect("octopod"));
  const msg::Id id = wire.submit(shipped_request("octopod-pa"));
  const auto end = wire.final_event(id, 60.0);
  ASSERT_TRUE(end);
  ASSERT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
  EXPECT_TRUE(end->message.summary().optimal());
  ASSERT_TRUE(wire.wait_for_steps(id, end->message.steps()));
  const auto steps = wire.steps(id);
  ASSERT_GT(steps.size(), 2u);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const msg::Step& step = steps[k].message;
    EXPECT_EQ(step.index(), k);
    EXPECT_EQ(step.joints().size(), 27u);
    EXPECT_EQ(step.placed().size(), 8u);
    EXPECT_EQ(step.stance().size(), 8u);
    EXPECT_FALSE(step.margins().empty());
    EXPECT_FALSE(step.shapes().empty());
  }
  EXPECT_NEAR(steps.back().message.cost(), end->message.summary().cost(), 1e-9);
}

TEST_P(Octopod, StreamsTheMotionOfLegsAndBodies) {
  Daemon daemon(options(GetParam().server));
  Wire wire(GetParam().client, kDomain);
  ASSERT_TRUE(wire.connect("octopod"));
  msg::PlanRequest request = shipped_request("octopod-ditch");
  request.goal().base()[0].position().x(-0.9);  // on this side: the first part of the way
  const msg::Id id = wire.submit(request);
  const auto end = wire.final_event(id, 110.0);
  ASSERT_TRUE(end);
  ASSERT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
  ASSERT_TRUE(wire.wait_for_steps(id, end->message.steps()));
  ASSERT_GT(end->message.steps(), 1u);
  for (const auto& step : wire.steps(id)) EXPECT_GT(step.message.motion().size(), 2u);
}

TEST_P(Octopod, RefusesWithTheFieldAndGoesOn) {
  Daemon daemon(options(GetParam().server));
  Wire wire(GetParam().client, kDomain);
  ASSERT_TRUE(wire.connect("octopod"));
  msg::PlanRequest off = shipped_request("octopod-pa");
  off.goal().base()[0].position().z() += 0.5;
  const auto refused = wire.final_event(wire.submit(off), 60.0);
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->message.state(), msg::FAILED) << describe(refused->message);
  EXPECT_EQ(refused->message.error().code(), msg::INVALID_GOAL);
  EXPECT_EQ(refused->message.error().field(), "goal.base.position");
  const auto end = wire.final_event(wire.submit(shipped_request("octopod-pa")), 60.0);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
}

INSTANTIATE_TEST_SUITE_P(Pairs, Octopod, testing::Values(kVendorPairs[0], kVendorPairs[3]), pair_name);

}  // namespace
}  // namespace foothold::test
