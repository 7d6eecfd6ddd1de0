// The stochastic method, rule by rule, where the result is forced.
#include <gtest/gtest.h>

#include <set>

#include "spaces.hpp"

namespace foothold::bioloid::paper::testing {
namespace {

constexpr auto kAll = [](const Point&) { return true; };

Plan found_in(const Space& space, const Point& start, const Point& goal, std::uint64_t seed, Options options = {.trim = false}) {
  std::mt19937_64 random(seed);
  return plan(space, start, goal, options, random);
}

TEST(Stochastic, EveryJointAdvancesToItsGoalAndIsExcludedThere) {
  const Plan found = found_in(grid(point({9, 9, 9, 9}), kAll), point({0, 7, 3, 2}), point({3, 5, 3, 3}), 1);
  EXPECT_EQ(found.path, points({{0, 7, 3, 2}, {1, 6, 3, 3}, {2, 5, 3, 3}, {3, 5, 3, 3}}));
  EXPECT_EQ(found.iterations, 3u);
}

TEST(Stochastic, AJointStopsOnAGoalWithinAStep) {
  Space space = grid(point({9, 9}), kAll);
  space.step = point({1.0, 0.4});
  EXPECT_EQ(found_in(space, point({0, 1}), point({1.5, 0}), 1).path, points({{0, 1}, {1, 0.6}, {1.5, 0.6 - 0.4}, {1.5, 0}}));
}

TEST(Stochastic, TheFarthestJointIsTheOneThatNeedsMostIterations) {
  Space space = grid(point({40, 12}), [](const Point& at) { return at != point({10, 1}); });
  space.step = point({10.0, 1.0});
  const Plan found = found_in(space, point({0, 0}), point({30, 10}), 1, {.trim = false, .growth = 1});
  ASSERT_EQ(found.ending, Ending::kReached);
  EXPECT_EQ(found.path[1], point({0, 1})) << "the second needs ten, the first three";
  EXPECT_EQ(found.path[2], point({10, 2})) << "directions computed anew";
}

TEST(Stochastic, WhereTheFarthestIsBlockedTheOthersGoOn) {
  const Space space = grid(point({9, 9}), [](const Point& at) { return !(at.y() == 1.0 && at.x() < 2.0); });
  const Plan found = found_in(space, point({0, 0}), point({3, 9}), 1, {.trim = false, .growth = 1});
  ASSERT_EQ(found.ending, Ending::kReached);
  EXPECT_EQ(found.path[1], point({1, 0}));
  EXPECT_EQ(found.path[2], point({2, 1}));
}

// A wall with one gap at its end: X has arrived, Y is blocked.
Space wall_with_gap() {
  return grid(point({6, 10}), [](const Point& at) { return at.y() != 5.0 || at.x() == 0.0; });
}

TEST(Stochastic, RetiredJointsMoveBeyondTheirGoalsUntilTheFarthestPasses) {
  std::set<double> first_ways;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Plan found = found_in(wall_with_gap(), point({3, 9}), point({3, 1}), seed, {.trim = false, .growth = 1});
    ASSERT_EQ(found.ending, Ending::kReached);
    expect_valid(wall_with_gap(), found.path, point({3, 9}), point({3, 1}));
    EXPECT_EQ(found.path[3], point({3, 6})) << "straight to the wall";
    std::size_t k = 3;
    for (; found.path[k].y() != 5.0; ++k) EXPECT_EQ(found.path[k].y(), 6.0) << "the blocked one keeps its value";
    EXPECT_EQ(found.path[k], point({0, 5}));
    EXPECT_EQ(found.path[k + 1], point({1, 4})) << "directions are computed anew";
    first_ways.insert(found.path[4].x() - 3.0);
  }
  EXPECT_EQ(first_ways, (std::set<double>{-1.0, 1.0})) << "at random";
}

TEST(Stochastic, AHoleIsJumpedByAGreaterStep) {
  const Space space = grid(point({10}), [](const Point& at) { return at.x() != 5.0; });
  const Plan found = found_in(space, point({0}), point({10}), 1, {.trim = false, .growth = 2});
  EXPECT_EQ(found.path, points({{0}, {1}, {2}, {3}, {4}, {6}, {7}, {8}, {9}, {10}}));
  EXPECT_EQ(found.jumps, 1u);
}

TEST(Stochastic, AHoleWiderThanTheGreatestStepIsNotJumped) {
  const Space space = grid(point({10}), [](const Point& at) { return at.x() != 5.0 && at.x() != 6.0; });
  EXPECT_EQ(found_in(space, point({0}), point({10}), 1, {.trim = false, .iterations = 5000, .growth = 2}).ending, Ending::kCapped);
  const Plan found = found_in(space, point({0}), point({10}), 1, {.trim = false, .growth = 3});
  ASSERT_EQ(found.ending, Ending::kReached);
  EXPECT_EQ(found.movements(), 8u);
}

TEST(Stochastic, NoHoleIsJumpedWhereTheMovementItselfIsJudged) {
  Space space = grid(point({10}), [](const Point& at) { return at.x() != 5.0; });
  space.joins = [](const Point& a, const Point& b) { return (a.x() < 5.0) == (b.x() < 5.0); };
  const Plan found = found_in(space, point({0}), point({10}), 1, {.trim = false, .iterations = 5000});
  EXPECT_EQ(found.ending, Ending::kCapped);
  EXPECT_EQ(found.jumps, 0u);
}

// No way through: X wanders along the wall until there is no advance.
TEST(Stochastic, TheBestApproachIsTakenUpAgainWhereNoAdvanceIsPossible) {
  Space space = grid(point({40, 10}), [](const Point& at) { return at.y() != 5.0; });
  std::vector<Point> proposed;
  space.valid = [&proposed, valid = space.valid](const Point& at) { return proposed.push_back(at), valid(at); };
  const Plan found =
      found_in(space, point({20, 10}), point({20, 0}), 7, {.trim = false, .iterations = 2000, .growth = 1, .patience = 40});
  EXPECT_EQ(found.ending, Ending::kCapped);
  EXPECT_TRUE(found.path.empty());
  EXPECT_GT(found.returns, 10u);
  std::size_t back = 0, from_the_start = 0;
  for (std::size_t k = 1; k < proposed.size(); ++k) {
    if (std::abs(proposed[k - 1].x() - 20.0) < 5.0 || std::abs(proposed[k].x() - 20.0) > 1.0) continue;
    ++back;
    from_the_start += proposed[k].y() == 10.0;
  }
  EXPECT_GE(back + 1, found.returns)
      << "each time from far out on the wall to the approach straight over it; perhaps not after the last";
  EXPECT_LE(back, found.returns);
  EXPECT_GT(from_the_start, 0u) << "in the end from the start";
  EXPECT_LT(from_the_start, back);
}

// A dead end that the straight way leads into: only from farther back does another way lead on.
TEST(Stochastic, GetsOutOfAPocket) {
  const Space space = grid(point({20, 20}), [](const Point& at) {
    const bool walls = at.x() >= 4 && at.x() <= 16 && at.y() >= 6 && at.y() <= 14;
    const bool inside = at.x() >= 6 && at.x() <= 14 && at.y() >= 8;
    return !walls || inside;
  });
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Plan found = found_in(space, point({10, 18}), point({10, 1}), seed, {.trim = true, .growth = 1});
    ASSERT_EQ(found.ending, Ending::kReached) << seed;
    EXPECT_GT(found.returns, 0u);
    expect_valid(space, found.path, point({10, 18}), point({10, 1}));
  }
}

// All joints that wander move at once: where one of them must not, it has to be let stay.
TEST(Stochastic, AWanderingJointMayHaveToStay) {
  const Space space = grid(point({6, 10, 4}), [](const Point& at) { return (at.y() != 5.0 || at.x() == 0.0) && at.z() == 2.0; });
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Plan found = found_in(space, point({3, 9, 2}), point({3, 1, 2}), seed, {.trim = false, .iterations = 5000, .growth = 1});
    ASSERT_EQ(found.ending, Ending::kReached);
    expect_valid(space, found.path, point({3, 9, 2}), point({3, 1, 2}));
  }
}

TEST(Stochastic, TheSameSeedFindsTheSamePath) {
  const Space space = wall_with_gap();
  const auto path = [&](std::uint64_t seed) { return found_in(space, point({3, 9}), point({3, 1}), seed).path; };
  EXPECT_EQ(path(5), path(5));
}

}  // namespace
}  // namespace foothold::bioloid::paper::testing
