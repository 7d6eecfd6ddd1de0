// HyReCRo's planner in the real server, over DDS: the shipped request, every step in order, replays, cancels.
#include <filesystem>

#include "daemon.hpp"
#include "foothold/client/request_file.hpp"
#include "foothold/msg/errors.hpp"
#include "vendor_pairs.hpp"
#include "wire.hpp"

namespace foothold::test {
namespace {

constexpr std::uint32_t kDomain = 19;

DaemonOptions options(const std::string& vendor) {
  return {.vendor = vendor,
          .domain = kDomain,
          .robots = {{.name = "hyrecro", .file = FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml"}},
          .more = "scenes: {preload: [" FOOTHOLD_CONFIG_DIR "/scenes]}\n",
          .plugin_dir = FOOTHOLD_PLUGINS};
}

msg::PlanRequest shipped_request(const std::string& stem) {
  return client::read_request_file(FOOTHOLD_CONFIG_DIR "/requests/" + stem + ".yaml").request;
}

class Hyrecro : public testing::TestWithParam<VendorPair> {};

TEST_P(Hyrecro, StreamsThePapersCrossedBeamsStepByStep) {
  Daemon daemon(options(GetParam().server));
  Wire wire(GetParam().client, kDomain);
  ASSERT_TRUE(wire.connect("hyrecro"));
  const msg::PlanRequest request = shipped_request("hyrecro-crossed-beams");
  const msg::Id id = wire.submit(request);
  const auto end = wire.final_event(id, 30.0);
  ASSERT_TRUE(end);
  ASSERT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
  EXPECT_TRUE(end->message.summary().optimal());
  ASSERT_TRUE(wire.wait_for_steps(id, end->message.steps()));
  const auto steps = wire.steps(id);
  ASSERT_EQ(steps.size(), end->message.summary().cost());
  EXPECT_LE(steps.size(), 11u);  // the paper's
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const msg::Step& step = steps[k].message;
    EXPECT_EQ(step.index(), k);
    EXPECT_EQ(step.joints().size(), 10u);
    EXPECT_EQ(step.stance().size(), 2u);
    EXPECT_FALSE(step.motion().empty());
    EXPECT_FALSE(step.margins().empty());
  }
  const msg::Vector3& wanted = request.goal().contacts()[0].frame().position();
  const msg::Vector3& reached = steps.back().message.placed()[0].frame().position();
  EXPECT_NEAR(reached.x(), wanted.x(), 1e-9);
  EXPECT_NEAR(reached.y(), wanted.y(), 1e-9);
  EXPECT_NEAR(reached.z(), wanted.z(), 1e-9);
}

TEST_P(Hyrecro, RefusesWithTheFieldAndGoesOn) {
  Daemon daemon(options(GetParam().server));
  Wire wire(GetParam().client, kDomain);
  ASSERT_TRUE(wire.connect("hyrecro"));
  msg::PlanRequest off = shipped_request("hyrecro-crossed-beams");
  off.goal().contacts()[0].frame().position().z() += 0.4;
  const auto refused = wire.final_event(wire.submit(off), 30.0);
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->message.state(), msg::FAILED) << describe(refused->message);
  EXPECT_EQ(refused->message.error().code(), msg::INVALID_GOAL);
  EXPECT_EQ(refused->message.error().field(), "goal.contacts[0].position");
  const auto end = wire.final_event(wire.submit(shipped_request("hyrecro-crossed-beams")), 30.0);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->message.state(), msg::SUCCEEDED) << describe(end->message);
}

INSTANTIATE_TEST_SUITE_P(Pairs, Hyrecro, testing::Values(kVendorPairs[0], kVendorPairs[3]), pair_name);

}  // namespace
}  // namespace foothold::test
