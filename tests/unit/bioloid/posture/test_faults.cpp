// Each fault by itself: a sound posture or motion, changed in one thing.
#include <gtest/gtest.h>

#include <limits>

#include "reference.hpp"

namespace foothold::bioloid {
namespace {

using namespace testing;

constexpr Side kRight = Side::kRight;

// On the right foot, weight over it; the left sole at x, y, z, seen from the right one.
Joints on_one_foot(double x, double y, double z, double pelvis_x = 0.015, double pelvis_y = 0.0, double pelvis_z = 0.195) {
  const auto found = standing(shipped_model(), kRight, pose(pelvis_x, pelvis_y, pelvis_z), pose(x, y, z));
  EXPECT_TRUE(found);
  return found.value_or(Joints::Zero());
}
Support one_foot() { return {}; }
Support both_feet() { return {kRight, Isometry3d::Identity(), true, pose(0, 0.077, 0)}; }
Prism block(double x, double length, double height) {
  return {"block", {{x, -0.3}, {x + length, -0.3}, {x + length, 0.3}, {x, 0.3}}, height};
}

TEST(BioloidFaults, SoundOnesHaveNone) {
  Judge judge(shipped_model(), {});
  EXPECT_EQ(judge.posture(on_one_foot(0, 0.077, 0.01), one_foot()), Fault::kNone);
  EXPECT_EQ(judge.motion(on_one_foot(-0.03, 0.077, 0.01), on_one_foot(0.03, 0.077, 0.01), one_foot()), Fault::kNone);
  EXPECT_EQ(judge.posture(on_one_foot(0, 0.077, 0, 0.015, 0.0385), both_feet()), Fault::kNone);
}

TEST(BioloidFaults, Limit) {
  Judge judge(shipped_model(), {});
  const Joints good = on_one_foot(0, 0.077, 0.01);
  for (int j = 0; j < static_cast<int>(kJoints); ++j) {
    const auto& limits = shipped_model().joints[static_cast<std::size_t>(j)].limits;
    for (const double wrong : {limits.low - 1e-9, limits.high + 1e-9, std::numeric_limits<double>::quiet_NaN()}) {
      Joints bad = good;
      bad[j] = wrong;
      EXPECT_EQ(judge.posture(bad, one_foot()), Fault::kLimit);
      EXPECT_EQ(judge.motion(good, bad, one_foot()), Fault::kLimit);
      EXPECT_EQ(judge.motion(bad, good, one_foot()), Fault::kLimit);
    }
  }
}

TEST(BioloidFaults, SelfAlsoBetweenTheEnds) {
  Judge judge(shipped_model(), {});
  EXPECT_EQ(judge.posture(on_one_foot(0, 0.062, 0.01), one_foot()), Fault::kSelf);
  // An arm swings from before the body to behind it, through the hip block.
  Joints before = on_one_foot(0, 0.077, 0.01), behind = before;
  before[0] = -80 * kDegree;
  behind[0] = 80 * kDegree;
  before[2] = behind[2] = 85 * kDegree;
  ASSERT_EQ(judge.posture(before, one_foot()), Fault::kNone);
  ASSERT_EQ(judge.posture(behind, one_foot()), Fault::kNone);
  EXPECT_EQ(judge.motion(behind, before, one_foot()), Fault::kSelf);
}

TEST(BioloidFaults, GroundAlsoBetweenTheEnds) {
  Judge judge(shipped_model(), {});
  EXPECT_EQ(judge.posture(on_one_foot(0, 0.077, -0.0003), one_foot()), Fault::kGround);
  EXPECT_EQ(judge.posture(on_one_foot(0, 0.077, -0.0001), one_foot()), Fault::kNone);
  // Both legs swing like pendulums: between the ends the sole is lower.
  const Joints behind = on_one_foot(-0.05, 0.077, 0.001, 0.0, 0.0, 0.18), before = on_one_foot(0.05, 0.077, 0.001, 0.0, 0.0, 0.18);
  double lowest = 1.0;
  for (int k = 0; k <= 100; ++k)
    lowest = std::min(lowest, figures(shipped_model(), behind + 0.01 * k * (before - behind), one_foot()).sole);
  ASSERT_LT(lowest, -0.001);
  EXPECT_EQ(judge.motion(behind, before, one_foot()), Fault::kGround);
}

TEST(BioloidFaults, WhereTheSwingSoleTouchesIsPartOfTheQuestion) {
  Judge judge(shipped_model(), {});
  const Joints low = on_one_foot(0, 0.077, 0), high = on_one_foot(0, 0.077, 0.01);
  EXPECT_EQ(judge.motion(low, high, one_foot(), 1), Fault::kNone);
  EXPECT_EQ(judge.motion(high, low, one_foot(), 2), Fault::kNone);
  EXPECT_EQ(judge.motion(low, high, one_foot(), 2), Fault::kGround);  // the end does not touch
  EXPECT_EQ(judge.motion(low, high, one_foot(), 3), Fault::kGround);
  // A hair below the ground: only for a sole that touches down.
  const Joints sunk = on_one_foot(0, 0.077, -0.0001);
  EXPECT_EQ(judge.motion(sunk, high, one_foot(), 1), Fault::kNone);
  EXPECT_EQ(judge.motion(sunk, high, one_foot(), 0), Fault::kGround);
}

TEST(BioloidFaults, ObstacleAlsoBetweenTheEnds) {
  // A sill of 4 mm between the two places of the swing foot.
  const std::vector<Prism> prisms{block(0.055, 0.002, 0.004)};
  Judge judge(shipped_model(), {}, prisms);
  EXPECT_EQ(judge.posture(on_one_foot(0.03, 0.077, 0.002), one_foot()), Fault::kObstacle);
  EXPECT_EQ(judge.posture(on_one_foot(0.03, 0.077, 0.0065), one_foot()), Fault::kNone);
  EXPECT_EQ(judge.posture(on_one_foot(0.0, 0.077, 0.001), one_foot()), Fault::kNone);
  // The support foot itself may not stand on one.
  Support moved;
  moved.at = pose(0.03, 0.0, 0.0);
  EXPECT_EQ(judge.posture(on_one_foot(-0.03, 0.077, 0.01), moved), Fault::kObstacle);
  // From over the sill to before it, straight through.
  const Joints over = on_one_foot(0.03, 0.077, 0.0065), before = on_one_foot(0.0, 0.077, 0.001);
  Judge free(shipped_model(), {});
  ASSERT_EQ(free.motion(over, before, one_foot()), Fault::kNone);
  const std::vector<Prism> higher{block(0.055, 0.002, 0.0041), block(0.0535, 0.0005, 0.0042)};
  Judge tight(shipped_model(), {}, higher);
  ASSERT_EQ(tight.posture(over, one_foot()), Fault::kNone);
  ASSERT_EQ(tight.posture(before, one_foot()), Fault::kNone);
  EXPECT_EQ(tight.motion(over, before, one_foot()), Fault::kObstacle);
}

TEST(BioloidFaults, BalanceAlsoBetweenTheEnds) {
  Judge judge(shipped_model(), {});
  EXPECT_EQ(judge.posture(on_one_foot(0, 0.077, 0.01, 0.015, 0.03), one_foot()), Fault::kBalance);
  EXPECT_EQ(judge.posture(on_one_foot(0, 0.077, 0.01, -0.05, 0.0, 0.18), one_foot()), Fault::kBalance);
  // Leaning from one side to the other is sound where both ends are: the support polygon is convex. But joints do not move the
  // centre of mass in a line: with a margin only just met at both ends, it is not met between.
  const Joints a = on_one_foot(-0.05, 0.077, 0.01, 0.0, 0.0, 0.18), b = on_one_foot(0.05, 0.077, 0.01, 0.0, 0.0, 0.18);
  const double least = std::min(judge.balance(a, one_foot()).margin, judge.balance(b, one_foot()).margin);
  double between = 1.0;
  for (int k = 0; k <= 100; ++k) between = std::min(between, judge.balance(a + 0.01 * k * (b - a), one_foot()).margin);
  ASSERT_LT(between, least - 1e-6);
  Demands exact;
  exact.balance = least - 1e-9;
  exact.ground = 1.0;
  Judge strict(shipped_model(), exact);
  ASSERT_EQ(strict.posture(a, one_foot()), Fault::kNone);
  ASSERT_EQ(strict.posture(b, one_foot()), Fault::kNone);
  EXPECT_EQ(strict.motion(a, b, one_foot(), 1), Fault::kBalance);
}

TEST(BioloidFaults, SlipAlsoBetweenTheEnds) {
  Judge judge(shipped_model(), {});
  Support support = both_feet();
  const Joints middle = on_one_foot(0, 0.077, 0, 0.015, 0.0385);
  support.second = pose(0, 0.0773, 0);
  EXPECT_EQ(judge.posture(middle, support), Fault::kSlip);
  support.second = pose(0, 0.077, 0, 0.0003);
  EXPECT_EQ(judge.posture(middle, support), Fault::kSlip);
  support.second = pose(0, 0.0771, 0, 0.0001);
  EXPECT_EQ(judge.posture(middle, support), Fault::kNone);
  // Far down and back up: the closed chain's joints do not follow lines.
  support = both_feet();
  const auto down = standing(shipped_model(), kRight, pose(0.03, 0.0385, 0.18, 0.1), support.second);
  ASSERT_TRUE(down);
  ASSERT_EQ(judge.posture(*down, support), Fault::kNone);
  EXPECT_EQ(judge.motion(middle, *down, support), Fault::kSlip);
}

TEST(BioloidFaults, AJudgeMayBeAskedForOneFootAfterTheOther) {
  Judge judge(shipped_model(), {});
  const Joints joints = on_one_foot(0, 0.077, 0.01);
  for (int twice = 0; twice < 2; ++twice) {
    EXPECT_EQ(judge.posture(joints, one_foot()), Fault::kNone);
    EXPECT_NE(judge.posture(joints, Support{Side::kLeft, Isometry3d::Identity(), false, Isometry3d::Identity()}), Fault::kNone);
  }
}

}  // namespace
}  // namespace foothold::bioloid
