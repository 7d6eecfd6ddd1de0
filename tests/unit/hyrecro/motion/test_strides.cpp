// Motions of single strides, each sampled a thousand times and judged by forward kinematics.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "fixtures.hpp"
#include "hyrecro/motion/lift.hpp"
#include "hyrecro/motion/liftable.hpp"
#include "hyrecro/motion/transfer.hpp"

namespace foothold::hyrecro {
namespace {

using testing::fault_of;
using testing::random_stance;
using testing::shipped_model;

const Isometry3d kOrigin = Isometry3d::Identity();

bool same(const Motion& a, const Motion& b) {
  if (a.times != b.times || a.points.size() != b.points.size()) return false;
  for (std::size_t k = 0; k < a.points.size(); ++k)
    if (to_joints(shipped_model(), a.points[k], Foot::kA) != to_joints(shipped_model(), b.points[k], Foot::kA)) return false;
  return true;
}

TEST(Strides, OnAPlaneAreFoundWhereverTheFootCanBeLiftedAndHoldUnderDenseSampling) {
  const truss::Truss truss = testing::plane();
  const Obstacles obstacles(truss);
  const MotionOptions options;
  const std::unique_ptr<Reachability> exact = make_exact(shipped_model(), options.clearance);
  std::mt19937_64 random(5);
  const int strides = std::getenv("FOOTHOLD_LONG") ? 5000 : 500;
  int found = 0, possible = 0;
  for (int n = 0; n < strides; ++n) {
    const Coordinates from = random_stance(obstacles, random, options.clearance),
                      to = random_stance(obstacles, random, options.clearance);
    const MotionResult result = plan_motion(shipped_model(), obstacles, kOrigin, from, to, true, options, random, {});
    const bool can = free_foot_liftable(*exact, forward(shipped_model(), from), options.lift) &&
                     free_foot_liftable(*exact, forward(shipped_model(), to), options.lift);
    possible += can ? 1 : 0;
    if (!result.motion) {
      EXPECT_FALSE(result.reason.empty());
      continue;
    }
    EXPECT_TRUE(can) << n;
    ++found;
    ASSERT_EQ(fault_of(obstacles, kOrigin, from, to, true, options, *result.motion, 1000), "") << n;
  }
  EXPECT_GE(found, possible * 99 / 100) << "of " << possible;
  EXPECT_GE(possible, strides * 9 / 10);
}

TEST(Strides, FromTheAirBeginWithoutALift) {
  const truss::Truss truss = testing::plane();
  const Obstacles obstacles(truss);
  const MotionOptions options;
  std::mt19937_64 random(6);
  const double middle = 0.5 * (shipped_model().mechanism.shortest() + shipped_model().mechanism.longest());
  const kinematics::PlanarMechanism::Pose longer = shipped_model().mechanism.forward({middle + 0.02, middle + 0.02}),
                                          shorter = shipped_model().mechanism.forward({middle - 0.02, middle - 0.02});
  const Coordinates from{{Leg{0.0, longer.y, 0.0, longer.y}, Leg{0.0, shorter.y, 0.0, shorter.y}}, {0.4, 0.4}};
  int found = 0;
  for (int n = 0; n < 50; ++n) {
    const Coordinates to = random_stance(obstacles, random, options.clearance);
    const MotionResult result = plan_motion(shipped_model(), obstacles, kOrigin, from, to, false, options, random, {});
    if (!result.motion) continue;
    ++found;
    ASSERT_EQ(fault_of(obstacles, kOrigin, from, to, false, options, *result.motion, 1000), "") << n;
  }
  EXPECT_GE(found, 40);
}

// From beside the X axis to before it, with a plate of 2 mm between both places.
struct Round {
  Coordinates from, to;
};
Round round_the_plate(const Obstacles& obstacles, std::mt19937_64& random) {
  Isometry3d beside = kOrigin, before = kOrigin;
  beside.linear() = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3d::UnitZ()).toRotationMatrix();
  beside.translation() << 0.05, 0.28, 0.0;
  before.translation() << 0.36, 0.12, 0.0;
  const auto from = testing::random_solution(obstacles, kOrigin, beside, random, 0.005),
             to = testing::random_solution(obstacles, kOrigin, before, random, 0.005);
  EXPECT_TRUE(from && to);
  return {from.value_or(Coordinates{}), to.value_or(Coordinates{})};
}

TEST(Strides, GoRoundAThinPlateAndNeverThroughIt) {
  const MotionOptions options;
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    std::mt19937_64 random(seed);
    const truss::Truss truss = testing::plane_with_plate(0.22, 0.16, 0.8, 0.15, 0.002);
    const Obstacles obstacles(truss);
    const Round round = round_the_plate(obstacles, random);
    const MotionResult result = plan_motion(shipped_model(), obstacles, kOrigin, round.from, round.to, true, options, random, {});
    if (!result.motion) continue;
    ++found;
    EXPECT_EQ(fault_of(obstacles, kOrigin, round.from, round.to, true, options, *result.motion, 4000), "") << seed;
  }
  EXPECT_GE(found, 5);
}

TEST(Strides, AreRefusedWithAReasonWhereAWallStandsBetweenTheFeet) {
  std::mt19937_64 random(3);
  const truss::Truss open = testing::plane(), closed = testing::plane_with_plate(0.22, -2.0, 2.0, 2.0, 0.002);
  const Obstacles without(open), with(closed);
  const MotionOptions options;
  const Round round = round_the_plate(without, random);
  const MotionResult result = plan_motion(shipped_model(), with, kOrigin, round.from, round.to, true, options, random, {});
  EXPECT_FALSE(result.motion);
  EXPECT_NE(result.reason, "");
}

TEST(Strides, RepeatThemselvesWithTheSameSeed) {
  const truss::Truss truss = testing::plane_with_plate(0.22, 0.16, 0.8, 0.15, 0.002);
  const Obstacles obstacles(truss);
  const MotionOptions options;
  std::mt19937_64 random(1);
  const Round round = round_the_plate(obstacles, random);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    std::mt19937_64 one(seed), two(seed);
    const MotionResult a = plan_motion(shipped_model(), obstacles, kOrigin, round.from, round.to, true, options, one, {}),
                       b = plan_motion(shipped_model(), obstacles, kOrigin, round.from, round.to, true, options, two, {});
    ASSERT_EQ(a.motion.has_value(), b.motion.has_value());
    EXPECT_EQ(a.reason, b.reason);
    if (a.motion) {
      EXPECT_TRUE(same(*a.motion, *b.motion));
    }
    EXPECT_EQ(one(), two());
  }
}

// Every way asked of RRTConnect, whether or not one in closed form is free.
TEST(Connect, FindsWaysThatHoldUnderDenseSamplingAndRepeatsThem) {
  const truss::Truss truss = testing::plane_with_plate(0.22, 0.16, 0.8, 0.15, 0.002);
  const Obstacles obstacles(truss);
  const Surroundings around{shipped_model(), obstacles, kOrigin, 0.005, {}};
  std::mt19937_64 random(9);
  int found = 0;
  for (int n = 0; n < 10; ++n) {
    const Round round = round_the_plate(obstacles, random);
    const auto a = lifted(shipped_model(), round.from, 0.02), b = lifted(shipped_model(), round.to, 0.02);
    if (!a || !b) continue;
    const Actuators begin = to_actuators(shipped_model(), *a), end = with_nearest_turns(begin, to_actuators(shipped_model(), *b));
    const std::uint64_t seed = random();
    std::mt19937_64 one(seed), two(seed);
    const auto way = connect(around, begin, {end}, 5000, one), again = connect(around, begin, {end}, 5000, two);
    ASSERT_EQ(way, again);
    if (!way) continue;
    ++found;
    EXPECT_EQ(way->front(), begin);
    EXPECT_EQ(way->back(), end);
    for (std::size_t k = 1; k < way->size(); ++k)
      for (int s = 0; s <= 500; ++s) {
        const Coordinates c = from_actuators(shipped_model(), (*way)[k - 1] + s / 500.0 * ((*way)[k] - (*way)[k - 1]));
        const Bodies bodies = bodies_at(shipped_model(), c, kOrigin);
        ASSERT_TRUE(within_limits(shipped_model(), c) && obstacles.free(bodies, 0.005 - 1e-9) &&
                    free_of_itself(bodies, 0.005 - 1e-9));
      }
  }
  EXPECT_GE(found, 3);
}

TEST(Strides, EndAtOnceWhenStopped) {
  const truss::Truss truss = testing::plane();
  const Obstacles obstacles(truss);
  std::mt19937_64 random(7);
  const Coordinates from = random_stance(obstacles, random, 0.005), to = random_stance(obstacles, random, 0.005);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(plan_motion(shipped_model(), obstacles, kOrigin, from, to, true, {}, random, stop.get_token()).motion);
}

TEST(JointRows, GoOnWithoutJumpsFromTheRowBefore) {
  const truss::Truss truss = testing::plane();
  const Obstacles obstacles(truss);
  std::mt19937_64 random(8);
  for (int n = 0; n < 20; ++n) {
    const Coordinates from = random_stance(obstacles, random, 0.005), to = random_stance(obstacles, random, 0.005);
    const MotionResult result = plan_motion(shipped_model(), obstacles, kOrigin, from, to, true, {}, random, {});
    if (!result.motion) continue;
    std::vector<double> last = to_joints(shipped_model(), from, Foot::kB);
    last[8] += 4.0 * std::numbers::pi;
    for (const std::vector<double>& row : joint_rows(shipped_model(), *result.motion, Foot::kB, last)) {
      EXPECT_LE(std::fabs(row[8] - last[8]), 0.5 * std::numbers::pi);
      EXPECT_LE(std::fabs(row[9] - last[9]), 0.5 * std::numbers::pi);
      last = row;
    }
  }
}

}  // namespace
}  // namespace foothold::hyrecro
