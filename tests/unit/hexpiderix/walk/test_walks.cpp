// Walks over slopes, changes of slope and generated terrains: every half cycle before the judge, every instant above the bound.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "../grounds.hpp"
#include "judged.hpp"

namespace foothold::hexpiderix::testing {
namespace {

TEST(Walk, TwoMetresOnLevelGround) {
  const Ground ground(terrain::parse_terrain(bent_ground(0, 0, 0)));
  const WalkOptions options;
  const auto from = stand_at(shipped_model(), ground, {on(ground, -1, 0), 0.3}, options);
  ASSERT_TRUE(from);
  const Walk found = walk(shipped_model(), ground, *from, {on(ground, 1, 0.2), -0.4}, options, {});
  ASSERT_EQ(found.end, Walk::End::kArrived) << found.because;
  expect_sound(ground, *from, found, options);
  const Isometry3d& last = found.half_cycles.back().to.at.thorax;
  EXPECT_NEAR(last.translation().x(), 1.0, 1e-9);
  EXPECT_NEAR(last.translation().y(), 0.2, 1e-9);
  EXPECT_NEAR(std::atan2(last.linear()(1, 0), last.linear()(0, 0)), -0.4, 1e-9);
  EXPECT_GE(found.half_cycles.size(), 34U) << "two metres are 34 strides of 6 cm at least";
}

TEST(Walk, OverSlopesAndTheirChangesEveryInstantKeepsTheBound) {
  std::mt19937_64 random(1);
  const int count = std::getenv("FOOTHOLD_LONG") ? 200 : 24;
  std::uniform_real_distribution<double> slope(-25, 25), any(0, 2 * std::numbers::pi), place(-0.8, 0.8);
  int arrived = 0;
  for (int i = 0; i < count; ++i) {
    const double first = slope(random) * kDegree, second = i % 2 ? first : slope(random) * kDegree;
    const Ground ground(terrain::parse_terrain(bent_ground(first, second, any(random))));
    WalkOptions options;
    options.least_nesm = 3e-3;
    const auto from = stand_at(shipped_model(), ground, {on(ground, place(random), place(random)), any(random)}, options);
    if (!from) continue;
    const Walk found = walk(shipped_model(), ground, *from, {on(ground, place(random), place(random)), any(random)}, options, {});
    if (found.end == Walk::End::kArrived) {
      ++arrived;
      expect_sound(ground, *from, found, options);
    } else {
      EXPECT_FALSE(found.because.empty());
    }
  }
  std::printf("%d of %d walks arrive\n", arrived, count);
  EXPECT_GE(arrived, count / 2);
}

TEST(Walk, StopsWhenItIsToldTo) {
  const Ground ground(terrain::parse_terrain(bent_ground(0, 0, 0)));
  const auto from = stand_at(shipped_model(), ground, {on(ground, -1, 0), 0.0}, {});
  ASSERT_TRUE(from);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(walk(shipped_model(), ground, *from, {on(ground, 1, 0), 0.0}, {}, stop.get_token()).end, Walk::End::kStopped);
}

TEST(Walk, OffTheTerrainItSaysWhere) {
  const Ground ground(terrain::parse_terrain(bent_ground(0, 0, 0)));
  const auto from = stand_at(shipped_model(), ground, {on(ground, 1, 0), 0.0}, {});
  ASSERT_TRUE(from);
  const Walk found = walk(shipped_model(), ground, *from, {{3, 0, 0}, 0.0}, {}, {});
  EXPECT_EQ(found.end, Walk::End::kBlocked);
  EXPECT_EQ(found.because, "there is no ground under a foot");
  EXPECT_NEAR(found.farthest.x(), 2.3, 0.1);
}

}  // namespace
}  // namespace foothold::hexpiderix::testing
