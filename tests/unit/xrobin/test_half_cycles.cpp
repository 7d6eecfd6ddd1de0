// Merged poses: complete, distinct, and each word leads where its pose says.
#include <gtest/gtest.h>

#include <random>

#include "brute_force.hpp"
#include "fixtures.hpp"
#include "half_cycles.hpp"
#include "workspace.hpp"

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

TEST(Workspace, HoldsTheEndOfEveryWordAndNothingElse) {
  HalfCycles poses{mechanism()};
  ASSERT_TRUE(poses.grow(4, {}));
  for (int cycles = 1; cycles <= 2; ++cycles) {
    const std::vector<PlanarPose> workspace_poses = workspace(poses, cycles);
    std::vector<bool> met(workspace_poses.size(), false);
    for (const PlanarPose& end : ends_of_all_words(poses.mechanism(), cycles)) {
      bool found = false;
      for (std::size_t k = 0; k < workspace_poses.size() && !found; ++k) {
        found = distance(workspace_poses[k], end) < 1e-10 && std::abs(wrapped(workspace_poses[k].heading - end.heading)) < 1e-10;
        if (found) met[k] = true;
      }
      EXPECT_TRUE(found);
    }
    EXPECT_TRUE(std::all_of(met.begin(), met.end(), [](bool m) { return m; }));
  }
  EXPECT_EQ(workspace(poses, 1).size(), 55u);
  EXPECT_EQ(workspace(poses, 2).size(), 2427u);
}

TEST(Workspace, OfOneCycleIsPartOfThatOfTwo) {
  // Every plan of fewer cycles is one of more: a cycle of equal configurations goes nowhere.
  HalfCycles poses{mechanism()};
  ASSERT_TRUE(poses.grow(4, {}));
  const std::vector<PlanarPose> two = workspace(poses, 2);
  for (const PlanarPose& one : workspace(poses, 1))
    EXPECT_TRUE(std::any_of(two.begin(), two.end(), [&](const PlanarPose& p) {
      return distance(p, one) < 1e-10 && std::abs(wrapped(p.heading - one.heading)) < 1e-10;
    }));
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
