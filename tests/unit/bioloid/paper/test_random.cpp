// The fully random method.
#include <gtest/gtest.h>

#include <map>

#include "spaces.hpp"

namespace foothold::bioloid::paper::testing {
namespace {

constexpr auto kAll = [](const Point&) { return true; };

Options random_options(bool removal = false) { return {.method = Method::kRandom, .clean = removal, .trim = removal}; }

TEST(Random, EachJointHasThreeEquallyLikelyChoices) {
  Space space = grid(point({2000, 2000}), kAll);
  std::vector<Point> proposed;
  space.valid = [&](const Point& at) { return proposed.push_back(at), true; };
  std::mt19937_64 random(3);
  Options options = random_options();
  options.iterations = 36'000;
  const Plan found = plan(space, point({1000, 1000}), point({0, 0}), options, random);
  ASSERT_EQ(found.ending, Ending::kCapped);
  EXPECT_EQ(found.iterations, options.iterations);
  std::map<std::pair<int, int>, int> counts;
  // The first two were the start and the goal; the first movement counts from the start.
  proposed[1] = proposed[0];
  for (std::size_t k = 2; k < proposed.size(); ++k) {
    const Point way = proposed[k] - proposed[k - 1];
    ++counts[{static_cast<int>(way.x()), static_cast<int>(way.y())}];
  }
  counts[{0, 0}] = 36'000 - static_cast<int>(proposed.size() - 2);
  EXPECT_EQ(counts.size(), 9u);
  for (const auto& [way, count] : counts) EXPECT_NEAR(count, 4000, 300) << way.first << ' ' << way.second;
}

TEST(Random, JointsThatHaveArrivedAreNotHeld) {
  const Space space = grid(point({4, 8}), kAll);
  std::mt19937_64 random(1);
  const Plan found = plan(space, point({2, 0}), point({2, 8}), random_options(), random);
  ASSERT_EQ(found.ending, Ending::kReached);
  expect_valid(space, found.path, point({2, 0}), point({2, 8}));
  EXPECT_TRUE(std::any_of(found.path.begin(), found.path.end(), [](const Point& at) { return at.x() != 2.0; }));
}

TEST(Random, AnIterationToAnInvalidPointLeavesTheJointsWhereTheyAre) {
  // A corridor one wide: what is not along it is discarded.
  const Space space = grid(point({5, 5}), [](const Point& at) { return at.y() == 0.0 || at.x() == 5.0; });
  std::mt19937_64 random(2);
  for (int k = 0; k < 20; ++k) {
    const Plan found = plan(space, point({0, 0}), point({5, 5}), random_options(), random);
    ASSERT_EQ(found.ending, Ending::kReached);
    expect_valid(space, found.path, point({0, 0}), point({5, 5}));
    EXPECT_GT(found.iterations, found.movements());
  }
}

TEST(Random, WithoutUselessSectionsTheCorridorsPathIsTheOnlyOne) {
  const Space space = grid(point({5, 5}), [](const Point& at) { return at.y() == 0.0 || at.x() == 5.0; });
  std::mt19937_64 random(4);
  for (int k = 0; k < 20; ++k) {
    const Plan found = plan(space, point({0, 0}), point({5, 5}), random_options(true), random);
    ASSERT_EQ(found.ending, Ending::kReached);
    EXPECT_EQ(found.path, points({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 1}, {5, 2}, {5, 3}, {5, 4}, {5, 5}}));
    EXPECT_GT(found.found_movements, found.movements());
  }
}

TEST(Random, ReachesAGoalThatIsNoWholeNumberOfStepsAway) {
  const Space space = grid(point({5, 5}), kAll);
  std::mt19937_64 random(5);
  const Plan found = plan(space, point({0.0, 0.5}), point({2.7, 3.1}), random_options(true), random);
  ASSERT_EQ(found.ending, Ending::kReached);
  expect_valid(space, found.path, point({0.0, 0.5}), point({2.7, 3.1}));
}

TEST(Random, StopsWhenAsked) {
  const Space space = grid(point({5}), [](const Point& at) { return at.x() != 3.0; });
  std::mt19937_64 random(6);
  std::stop_source stop;
  Space stopping = space;
  int judged = 0;
  stopping.valid = [&](const Point& at) {
    if (++judged == 1000) stop.request_stop();
    return space.valid(at);
  };
  const Plan found = plan(stopping, point({0}), point({5}), random_options(), random, stop.get_token());
  EXPECT_EQ(found.ending, Ending::kStopped);
  EXPECT_EQ(judged, 1000);
  EXPECT_TRUE(found.path.empty());
}

TEST(Plans, SayWhatDoesNotFitTogether) {
  const auto refusal = [](const Space& space, const Point& start, const Point& goal) -> std::string {
    std::mt19937_64 random(1);
    try {
      plan(space, start, goal, {}, random);
    } catch (const std::invalid_argument& fault) {
      return fault.what();
    }
    return "";
  };
  Space space = grid(point({5, 5}), [](const Point& at) { return at.x() != 3.0; });
  EXPECT_NE(refusal(space, point({0, 0}), point({5})).find("same number of coordinates"), std::string::npos);
  EXPECT_EQ(refusal(space, point({0, 6}), point({5, 5})), "the start is outside the limits");
  EXPECT_EQ(refusal(space, point({0, 0}), point({-1, 5})), "the goal is outside the limits");
  EXPECT_EQ(refusal(space, point({3, 0}), point({5, 5})), "the start is not valid");
  EXPECT_EQ(refusal(space, point({0, 0}), point({3, 5})), "the goal is not valid");
  space.step[1] = 0.0;
  EXPECT_EQ(refusal(space, point({0, 0}), point({5, 5})), "every step has to be above 0");
}

}  // namespace
}  // namespace foothold::bioloid::paper::testing
