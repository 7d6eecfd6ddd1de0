// Lifts in closed form against forward kinematics, and what can be lifted against random search.
#include <gtest/gtest.h>

#include <cmath>

#include "fixtures.hpp"
#include "hyrecro/motion/lift.hpp"
#include "hyrecro/motion/liftable.hpp"
#include "hyrecro/motion/solutions.hpp"

namespace foothold::hyrecro {
namespace {

using testing::shipped_model;
using testing::uniform;

Coordinates random_posture(std::mt19937_64& random) {
  const auto& mechanism = shipped_model().mechanism;
  Actuators q;
  for (int i = 0; i < 8; ++i) q[i] = uniform(random, mechanism.shortest(), mechanism.longest());
  for (int i = 8; i < 10; ++i) q[i] = uniform(random, -3.1, 3.1);
  return from_actuators(shipped_model(), q);
}

TEST(Lift, TakesTheSoleUpItsOwnNormalWithoutATurnWhateverThePosture) {
  std::mt19937_64 random(21);
  int lifts = 0;
  for (int n = 0; n < 20'000; ++n) {
    const Coordinates stance = random_posture(random);
    const double height = uniform(random, 0.0, 0.05);
    const auto top = lifted(shipped_model(), stance, height);
    if (!top) continue;
    ++lifts;
    ASSERT_TRUE(within_limits(shipped_model(), *top)) << n;
    const Isometry3d off = forward(shipped_model(), stance).inverse() * forward(shipped_model(), *top);
    ASSERT_LT((off.translation() - Vector3d(0.0, 0.0, height)).norm(), 1e-12) << n;
    ASSERT_LT((off.linear() - Eigen::Matrix3d::Identity()).norm(), 1e-12) << n;
  }
  EXPECT_GT(lifts, 5'000);
}

TEST(Lift, KeepsTheLineBetweenItsPosturesAndWithinItsTolerance) {
  std::mt19937_64 random(22);
  constexpr double height = 0.02;
  int lifts = 0;
  for (int n = 0; n < 2'000; ++n) {
    const Coordinates stance = random_posture(random);
    const double tolerance = std::pow(10.0, uniform(random, -5.0, -3.0));
    const auto line = lift(shipped_model(), stance, height, tolerance);
    if (!line) continue;
    ++lifts;
    const Isometry3d sole = forward(shipped_model(), stance);
    for (std::size_t k = 1; k < line->size(); ++k) {
      const Actuators a = to_actuators(shipped_model(), (*line)[k - 1]), b = to_actuators(shipped_model(), (*line)[k]);
      for (int s = 0; s <= 20; ++s) {
        const Isometry3d off = sole.inverse() * forward(shipped_model(), from_actuators(shipped_model(), a + s / 20.0 * (b - a)));
        ASSERT_LE(off.translation().head<2>().norm(), tolerance) << n;
        ASSERT_LE(Eigen::AngleAxisd(off.linear()).angle(), tolerance) << n;
      }
    }
  }
  EXPECT_GT(lifts, 500);
}

TEST(Lift, SlidesOfTheWholeRobotEndAtTheirPostureAndKeepTheLine) {
  std::mt19937_64 random(23);
  constexpr double height = 0.02, tolerance = 5e-4;
  int slides = 0;
  for (int n = 0; n < 200; ++n) {
    const Coordinates stance = random_posture(random);
    const Isometry3d sole = forward(shipped_model(), stance), above = sole * Eigen::Translation3d(0.0, 0.0, height);
    const std::vector<Coordinates> tops = solutions(shipped_model(), above, {0.2, 0.02, 0.2}, &stance);
    for (std::size_t k = 0; k < tops.size(); k += 7) {
      const auto line = slide(shipped_model(), stance, tops[k], height, tolerance);
      if (!line) continue;
      ++slides;
      for (std::size_t i = 1; i < line->size(); ++i) {
        const Actuators a = to_actuators(shipped_model(), (*line)[i - 1]),
                        b = with_nearest_turns(a, to_actuators(shipped_model(), (*line)[i]));
        for (int s = 0; s <= 20; ++s) {
          const Coordinates c = from_actuators(shipped_model(), a + s / 20.0 * (b - a));
          const Isometry3d off = sole.inverse() * forward(shipped_model(), c);
          ASSERT_TRUE(within_limits(shipped_model(), c));
          ASSERT_LE(off.translation().head<2>().norm(), tolerance);
          ASSERT_LE(Eigen::AngleAxisd(off.linear()).angle(), tolerance);
          ASSERT_GE(off.translation().z(), -tolerance);
          ASSERT_LE(off.translation().z(), height + tolerance);
        }
      }
      const Isometry3d end = above.inverse() * forward(shipped_model(), line->back());
      ASSERT_LT(end.translation().norm(), 1e-7);
    }
  }
  EXPECT_GT(slides, 100);
}

TEST(Liftable, NeverDeniesWhatAGridOfPosturesFinds) {
  const std::unique_ptr<Reachability> exact = make_exact(shipped_model(), 0.005);
  const truss::Truss truss = testing::plane();
  const Obstacles obstacles(truss);
  std::mt19937_64 random(24);
  int no = 0;
  for (int n = 0; n < 400; ++n) {
    const Isometry3d pose = forward(shipped_model(), testing::random_stance(obstacles, random, 0.005));
    const double height = uniform(random, 0.01, 0.06);
    const bool free = free_foot_liftable(*exact, pose, height), holding = holding_foot_liftable(*exact, pose, height);
    no += free ? 0 : 1;
    const auto found = [&](const Isometry3d& of) {
      for (const Coordinates& c :
           solutions(shipped_model(), of * Eigen::Translation3d(0.0, 0.0, height), {0.1, 0.02, 0.2}, nullptr))
        if (free_of_itself(bodies_at(shipped_model(), c, Isometry3d::Identity()), 0.005)) return true;
      return false;
    };
    if (!free) {
      EXPECT_FALSE(found(pose)) << n;
    }
    if (!holding) {
      EXPECT_FALSE(found(pose.inverse())) << n;
    }
  }
  EXPECT_GT(no, 5);
}

}  // namespace
}  // namespace foothold::hyrecro
