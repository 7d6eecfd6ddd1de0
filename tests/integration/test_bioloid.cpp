// Bioloid's planner in the real server, over DDS: the shipped requests, every step in order with its motion, refusals.
#include "daemon.hpp"
#include "foothold/client/request_file.hpp"
#include "foothold/msg/errors.hpp"
#include "vendor_pairs.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

constexpr std::uint32_t kDomain = 26;

DaemonOptions options(const std::string& vendor) {
  return {.vendor = vendor,
          .domain = kDomain,
          .robots = {{.name = "bioloid", .file = FOOTHOLD_CONFIG_DIR "/robots/bioloid.yaml"}},
          .more = "scenes: {preload: [" FOOTHOLD_CONFIG_DIR "/scenes]}\n",
          .plugin_dir = FOOTHOLD_PLUGINS};
}

msg::PlanRequest shipped_request(const std::string& stem) {
  return client::read_request_file(FOOTHOLD_CONFIG_DIR "/requests/" + stem + ".yaml").request;
}

class Bioloid : public testing::TestWithParam<VendorPair> {};

TEST_P(Bioloid, StreamsTheFootholdsWithTheJointMotionBetweenThem) {
  Daemon daemon(options(GetParam().server));
  Wire wire(GetParam().client, kDomain);
  ASSERT_TRUE(wire.connect("bioloid"));
  const msg::Id id = wire.submit(shipped_request("bioloid-walk"));
  const auto end = wire.final_event(id, 60.0);
  ASSERT_TRUE(end);
  ASSERT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
  EXPECT_TRUE(end->message.summary().optimal());
  ASSERT_EQ(end->message.steps(), 21u);
  ASSERT_TRUE(wire.wait_for_steps(id, 21));
  const auto steps = wire.steps(id);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const msg::Step& step = steps[k].message;
    EXPECT_EQ(step.index(), k);
    ASSERT_EQ(step.placed().size(), 1u);
    EXPECT_EQ(step.placed()[0].limb(), k % 2 == 0 ? steps[0].message.placed()[0].limb() : steps[1].message.placed()[0].limb());
    EXPECT_EQ(step.joints().size(), 18u);
    EXPECT_GT(step.motion().size(), 50u);
    EXPECT_FALSE(step.margins().empty());
    EXPECT_FALSE(step.shapes().empty());
  }
}

TEST_P(Bioloid, WalksAmongObstaclesAndRefusesAGoalOnOne) {
  Daemon daemon(options(GetParam().server));
  Wire wire(GetParam().client, kDomain);
  ASSERT_TRUE(wire.connect("bioloid"));
  msg::PlanRequest request = shipped_request("bioloid-obstacles");
  request.budget(60.0);  // s: enough for a build with sanitizers
  const auto end = wire.final_event(wire.submit(request), 70.0);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
  msg::PlanRequest on_brick = shipped_request("bioloid-obstacles");
  on_brick.goal().base()[0].position().x() = 0.44;
  on_brick.goal().base()[0].position().y() = -0.15;
  const auto refused = wire.final_event(wire.submit(on_brick), 60.0);
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->message.state(), msg::FAILED) << describe(refused->message);
  EXPECT_EQ(refused->message.error().code(), msg::UNREACHABLE_GOAL);
  EXPECT_EQ(refused->message.error().field(), "goal.base.position");
}

INSTANTIATE_TEST_SUITE_P(Pairs, Bioloid, testing::Values(kVendorPairs[0], kVendorPairs[3]), pair_name);

}  // namespace
}  // namespace foothold::test
