// Motions of single strides, each sampled a thousand times and judged by forward kinematics.
#include <gtest/gtest.h>

#include <cstdlib>

#include "fixtures.hpp"

namespace foothold::hyrecro {
namespace {

using testing::fault_of;
using testing::random_stance;
using testing::shipped_model;

TEST(Strides, OnAPlaneAreFoundAndHoldUnderDenseSampling) {
  const truss::Truss truss = testing::plane();
  const Obstacles obstacles(truss);
  const MotionOptions options;
  std::mt19937_64 random(5);
  const int strides = std::getenv("FOOTHOLD_LONG") ? 2000 : 200;
  int found = 0;
  for (int n = 0; n < strides; ++n) {
    const Coordinates from = random_stance(obstacles, random, options.clearance),
                      to = random_stance(obstacles, random, options.clearance);
    const MotionResult result =
        plan_motion(shipped_model(), obstacles, Isometry3d::Identity(), from, to, true, options, random, {});
    if (!result.motion) continue;
    ++found;
    ASSERT_EQ(fault_of(obstacles, Isometry3d::Identity(), from, to, true, options, *result.motion, 1000), "") << n;
  }
  EXPECT_GE(found, strides * 8 / 10);
}

}  // namespace
}  // namespace foothold::hyrecro
