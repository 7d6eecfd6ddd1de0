// Hex-piderix' planner in the real server, over DDS: the shipped requests, every step in order, refusals.
#include <cmath>

#include "daemon.hpp"
#include "foothold/client/request_file.hpp"
#include "foothold/msg/errors.hpp"
#include "vendor_pairs.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

constexpr std::uint32_t kDomain = 24;

DaemonOptions options(const std::string& vendor) {
  return {.vendor = vendor,
          .domain = kDomain,
          .robots = {{.name = "hexpiderix", .file = FOOTHOLD_CONFIG_DIR "/robots/hexpiderix.yaml"}},
          .more = "scenes: {preload: [" FOOTHOLD_CONFIG_DIR "/scenes]}\n",
          .plugin_dir = FOOTHOLD_PLUGINS};
}

msg::PlanRequest shipped_request(const std::string& stem) {
  return client::read_request_file(FOOTHOLD_CONFIG_DIR "/requests/" + stem + ".yaml").request;
}

class Hexpiderix : public testing::TestWithParam<VendorPair> {};

TEST_P(Hexpiderix, SendsThePostureForFortyFiveDegreesAndItsFootholds) {
  Daemon daemon(options(GetParam().server));
  Wire wire(GetParam().client, kDomain);
  ASSERT_TRUE(wire.connect("hexpiderix"));
  const msg::Id id = wire.submit(shipped_request("hexpiderix-45"));
  const auto end = wire.final_event(id, 60.0);
  ASSERT_TRUE(end);
  ASSERT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
  EXPECT_TRUE(end->message.summary().optimal());
  ASSERT_EQ(end->message.steps(), 1u);
  ASSERT_TRUE(wire.wait_for_steps(id, 1));
  const msg::Step step = wire.steps(id).at(0).message;
  EXPECT_EQ(step.joints().size(), 18u);
  ASSERT_EQ(step.stance().size(), 3u);
  EXPECT_EQ(step.placed().size(), 3u);
  EXPECT_FALSE(step.margins().empty());
  EXPECT_FALSE(step.shapes().empty());
  EXPECT_LT(step.cost(), -0.02) << "the cost is minus the stability, and the paper's posture has 2.4 mm";
}

TEST_P(Hexpiderix, StreamsAWalkUpTheStairsStepByStep) {
  Daemon daemon(options(GetParam().server));
  Wire wire(GetParam().client, kDomain);
  ASSERT_TRUE(wire.connect("hexpiderix"));
  const msg::Id id = wire.submit(shipped_request("hexpiderix-walk"));
  const auto end = wire.final_event(id, 60.0);
  ASSERT_TRUE(end);
  ASSERT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
  ASSERT_TRUE(wire.wait_for_steps(id, end->message.steps()));
  const auto steps = wire.steps(id);
  ASSERT_GE(steps.size(), 20u) << "1.2 m at 6 cm a half cycle";
  double way = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const msg::Step& step = steps[k].message;
    EXPECT_EQ(step.index(), k);
    EXPECT_EQ(step.joints().size(), 18u);
    EXPECT_EQ(step.stance().size(), 6u);
    EXPECT_FALSE(step.margins().empty());
    EXPECT_GE(step.cost(), way);
    way = step.cost();
  }
  EXPECT_NEAR(way, end->message.summary().cost(), 1e-9);
}

TEST_P(Hexpiderix, RefusesWithTheFieldAndGoesOn) {
  Daemon daemon(options(GetParam().server));
  Wire wire(GetParam().client, kDomain);
  ASSERT_TRUE(wire.connect("hexpiderix"));
  msg::PlanRequest off = shipped_request("hexpiderix-45");
  off.start().base()[0].position().z() += 0.5;
  const auto refused = wire.final_event(wire.submit(off), 60.0);
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->message.state(), msg::FAILED) << describe(refused->message);
  EXPECT_EQ(refused->message.error().code(), msg::INVALID_START);
  EXPECT_EQ(refused->message.error().field(), "start.base.position");
  const auto end = wire.final_event(wire.submit(shipped_request("hexpiderix-45")), 60.0);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
}

INSTANTIATE_TEST_SUITE_P(Pairs, Hexpiderix, testing::Values(kVendorPairs[0], kVendorPairs[3]), pair_name);

}  // namespace
}  // namespace foothold::test
