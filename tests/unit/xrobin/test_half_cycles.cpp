// Merged poses: complete, distinct, and each word leads where its pose says.
#include <gtest/gtest.h>

#include <random>

#include "fixtures.hpp"
#include "half_cycles.hpp"

namespace foothold::xrobin {
namespace {

TEST(HalfCycles, SevenHalfCyclesWithExactTurnsReach91914Poses) {
  HalfCycles poses{Mechanism(with_exact_turns(0.103, 0.130))};
  ASSERT_TRUE(poses.grow(7, {}));
  const std::size_t expected[] = {1, 8, 54, 326, 1580, 7342, 26768, 91914};
  for (int n = 0; n <= 7; ++n) EXPECT_EQ(poses.level(n).size(), expected[n]) << n;
}

TEST(HalfCycles, PrintedLengthsKeepNearlyEqualPosesApart) {
  HalfCycles poses{mechanism()};
  ASSERT_TRUE(poses.grow(5, {}));
  EXPECT_EQ(poses.level(2).size(), 55u);
  EXPECT_EQ(poses.level(3).size(), 372u);
  EXPECT_EQ(poses.level(4).size(), 2427u);
  EXPECT_EQ(poses.level(5).size(), 15740u);
}

TEST(HalfCycles, EveryWordOfFourHalfCyclesIsStoodFor) {
  for (const Mechanism& m : {mechanism(), Mechanism(with_exact_turns(0.103, 0.130))}) {
    HalfCycles poses(m);
    ASSERT_TRUE(poses.grow(4, {}));
    const PoseLevel& level = poses.level(4);
    for (int code = 0; code < 4096; ++code) {
      Word word;
      for (int k = 0; k < 4; ++k) word.push_back(static_cast<std::uint8_t>((code >> (3 * k)) % 8 + 1));
      const PlanarPose end = forward(m, word);
      bool found = false;
      for (std::size_t k = 0; k < level.size() && !found; ++k)
        found = std::hypot(level.x[k] - end.x, level.y[k] - end.y) <= poses.merge_bound(4) &&
                std::abs(wrapped(poses.turns().angle(level.turn[k]) - end.heading)) <= poses.merge_angle(4);
      ASSERT_TRUE(found) << code;
    }
  }
}

TEST(HalfCycles, WordsLeadToTheirPoses) {
  HalfCycles poses{mechanism()};
  ASSERT_TRUE(poses.grow(7, {}));
  std::mt19937_64 random(7);
  for (int n = 1; n <= 7; ++n) {
    const PoseLevel& level = poses.level(n);
    for (int k = 0; k < 200; ++k) {
      const auto id = static_cast<std::uint32_t>(random() % level.size());
      const BodyPoses end = trace(poses.mechanism(), poses.word(n, id)).back();
      const PlanarPose& moved = n % 2 == 1 ? end.b : end.a;
      EXPECT_LT(std::hypot(level.x[id] - moved.x, level.y[id] - moved.y), poses.merge_bound(n));
      EXPECT_LT(std::abs(wrapped(poses.turns().angle(level.turn[id]) - moved.heading)), poses.merge_angle(n));
    }
  }
}

TEST(HalfCycles, StopsWhenAskedAndGoesOnLater) {
  HalfCycles poses{mechanism()};
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(poses.grow(6, stop.get_token()));
  EXPECT_LT(poses.levels(), 6);
  EXPECT_TRUE(poses.grow(6, {}));
  EXPECT_EQ(poses.levels(), 6);
}

}  // namespace
}  // namespace foothold::xrobin
