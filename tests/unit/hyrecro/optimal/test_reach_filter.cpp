// The filter's "no" against what random postures reach.
#include "hyrecro/reach/reach_filter.hpp"

#include <gtest/gtest.h>

#include "poses.hpp"

namespace foothold::hyrecro {
namespace {

TEST(ReachFilter, LetsEveryPosePassThatAPostureReaches) {
  const ReachFilter filter(robot());
  std::mt19937_64 random(21);
  for (int i = 0; i < 60'000; ++i)
    for (const Kind kind : kKinds) {
      const Isometry3d pose = random_reached_pose(random, kind);
      ASSERT_TRUE(filter.may_reach(pose)) << "kind " << static_cast<int>(kind) << ", pose " << i << "\n" << pose.matrix();
    }
}

TEST(ReachFilter, StopsMostOfWhatIsOutOfReach) {
  const ReachFilter filter(robot());
  std::mt19937_64 random(22);
  int passed = 0;
  constexpr int kPoses = 20'000;
  for (int i = 0; i < kPoses; ++i) passed += filter.may_reach(random_pose(random, Kind::kGeneral)) ? 1 : 0;
  EXPECT_LT(passed, kPoses / 20);
}

}  // namespace
}  // namespace foothold::hyrecro
