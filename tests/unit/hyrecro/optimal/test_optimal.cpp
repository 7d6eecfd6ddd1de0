// Whole routes: every stride looked at again, proofs, objectives, bans, reasons.
#include "climbing.hpp"
#include "hyrecro/optimal/bounds.hpp"

namespace foothold::hyrecro {
namespace {

using Outcome = Found::Outcome;

Found plan(const PreparedTruss& scene, const Foothold& start, const Foothold& goal, const OptimalOptions& options = {}) {
  return plan_optimal(robot(), scene, start, goal, options, {}, {});
}

// The paper's Figure 10 as shipped: from the long beam's side over its top up the short beam.
struct Figure10 : testing::Test {
  std::unique_ptr<PreparedTruss> scene = prepared(crossed_beams());
  Foothold start = foothold_on(scene->truss, {0.2, -0.075, 0.0}, {90, 0, 0});
  Foothold goal = foothold_on(scene->truss, {1.425, 0.0, 0.43}, {0, -90, 0});
};

TEST_F(Figure10, TakesFewStridesAndProvesThatNoneIsLeftOut) {
  const Found found = plan(*scene, start, goal);
  ASSERT_EQ(found.outcome, Outcome::kReached);
  EXPECT_LE(found.route.strides.size(), 11u);
  EXPECT_EQ(found.cost, static_cast<double>(found.route.strides.size()));
  EXPECT_TRUE(found.optimal);
  EXPECT_EQ(found.lower_bound, found.cost);
  EXPECT_TRUE(same(found.route.strides.back().to, goal));
  expect_climbable(*scene, found.route);
}

void expect_same(const Found& a, const Found& b) {
  ASSERT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.lower_bound, b.lower_bound);
  ASSERT_EQ(a.route.strides.size(), b.route.strides.size());
  for (std::size_t k = 0; k < a.route.strides.size(); ++k) {
    EXPECT_EQ(a.route.strides[k].to.at, b.route.strides[k].to.at);
    EXPECT_EQ(a.route.strides[k].to.heading, b.route.strides[k].to.heading);
    EXPECT_EQ(a.route.strides[k].coordinates.hip, b.route.strides[k].coordinates.hip);
  }
}

TEST_F(Figure10, AnswersTheSameWhateverWasAskedBefore) {
  const Found fresh = plan(*scene, start, goal);
  const Foothold elsewhere = foothold_on(scene->truss, {0.3, 0.0, 0.075}, {0, 0, 0});
  plan(*scene, elsewhere, goal);
  plan(*scene, goal, elsewhere);
  expect_same(plan(*scene, start, goal), fresh);
}

// What is kept for one height to lift the feet by, or found while strides are banned, does not get into other answers.
TEST_F(Figure10, AnswersTheSameWhateverRoomWasDemandedAndWhateverWasBannedBefore) {
  const Foothold elsewhere = foothold_on(scene->truss, {0.5, 0.0, 0.075}, {0, 0, 180});
  std::vector<OptimalOptions> asked(5);
  asked[1].lift = asked[2].lift = 0.022;
  asked[3].lift = 0.05;
  const Found free = plan(*scene, start, goal, asked[1]);
  ASSERT_EQ(free.outcome, Outcome::kReached);
  for (const std::size_t k : {std::size_t{1}, free.route.strides.size() - 1})
    asked[2].banned.push_back({free.route.strides[k - 1].to, free.route.strides[k].to, 0.02});
  asked[4].banned = asked[2].banned;
  for (int round = 0; round < 2; ++round)
    for (const OptimalOptions& options : asked)
      for (const auto& [from, to] : {std::pair(start, goal), std::pair(elsewhere, goal), std::pair(goal, start)}) {
        const auto fresh = prepared(crossed_beams());
        expect_same(plan(*scene, from, to, options), plan(*fresh, from, to, options));
      }
}

TEST_F(Figure10, TheLeastWayIsNotLongerThanThatOfTheLeastStrides) {
  const Found steps = plan(*scene, start, goal);
  OptimalOptions options;
  options.objective = Objective::kDistance;
  const Found distance = plan(*scene, start, goal, options);
  ASSERT_EQ(distance.outcome, Outcome::kReached);
  expect_climbable(*scene, distance.route);
  EXPECT_NEAR(distance.cost, length_of(*scene, distance.route), 1e-9);
  EXPECT_LE(distance.cost, length_of(*scene, steps.route) + 1e-9);
  EXPECT_LE(distance.lower_bound, distance.cost);
  EXPECT_GE(distance.route.strides.size(), steps.route.strides.size());
}

TEST_F(Figure10, KeepsOffStridesThatAreBanned) {
  const Found before = plan(*scene, start, goal);
  OptimalOptions options;
  for (std::size_t k = 0; k < before.route.strides.size(); ++k) {
    const Foothold& from = k == 0 ? before.route.start : before.route.strides[k - 1].to;
    options.banned.push_back({before.route.strides[k].to, from});
    const Found found = plan(*scene, start, goal, options);
    ASSERT_EQ(found.outcome, Outcome::kReached) << "ban " << k;
    EXPECT_GE(found.cost, before.cost);
    expect_climbable(*scene, found.route);
    Foothold at = start;
    for (const Stride& stride : found.route.strides) {
      for (const Ban& ban : options.banned) {
        EXPECT_FALSE(same(ban.one, at) && same(ban.other, stride.to));
        EXPECT_FALSE(same(ban.other, at) && same(ban.one, stride.to));
      }
      at = stride.to;
    }
  }
}

TEST_F(Figure10, NoStrideIsNeededWhereOneStandsAlready) {
  const Found found = plan(*scene, start, start);
  EXPECT_EQ(found.outcome, Outcome::kReached);
  EXPECT_TRUE(found.route.strides.empty());
  EXPECT_TRUE(found.optimal);
}

TEST_F(Figure10, HandsOverTheStridesInOrderAndStopsWhenTheReceiverDoes) {
  std::vector<Stride> got;
  const Found found = plan_optimal(robot(), *scene, start, goal, {}, {}, [&](const Stride& stride) {
    got.push_back(stride);
    return true;
  });
  ASSERT_EQ(got.size(), found.route.strides.size());
  for (std::size_t k = 0; k < got.size(); ++k) EXPECT_TRUE(same(got[k].to, found.route.strides[k].to));
  EXPECT_EQ(plan_optimal(robot(), *scene, start, goal, {}, {}, [](const Stride&) { return false; }).outcome, Outcome::kStopped);
}

TEST_F(Figure10, StopsWhenAskedAndGivesUpAtItsLimit) {
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(plan_optimal(robot(), *scene, start, goal, {}, source.get_token(), {}).outcome, Outcome::kStopped);
  OptimalOptions options;
  options.max_nodes = 3;
  const Found found = plan(*scene, start, goal, options);
  EXPECT_EQ(found.outcome, Outcome::kFailed);
  EXPECT_EQ(found.failure.error, PlanError::kSearchLimit);
}

truss::Truss two_beams_apart(double gap) {
  return truss::parse_truss(
      "kind: truss\ndescription: apart\nbeams:\n"
      "  - {name: here, from: [0, 0, 0], to: [2, 0, 0], profile: {width: 0.15, height: 0.15}, up: [0, 0, 1]}\n"
      "  - {name: there, from: [0, " +
      std::to_string(gap) + ", 0], to: [2, " + std::to_string(gap) +
      ", 0], profile: {width: 0.15, height: 0.15}, up: [0, 0, 1]}\n");
}

TEST(Reasons, AGoalTooFarOffNamesItsFaceAndTheDistance) {
  const auto scene = prepared(two_beams_apart(5.0));
  const Found found =
      plan(*scene, foothold_on(scene->truss, {1, 0, 0.075}, {0, 0, 0}), foothold_on(scene->truss, {1, 5.0, 0.075}, {0, 0, 0}));
  ASSERT_EQ(found.outcome, Outcome::kFailed);
  EXPECT_EQ(found.failure.error, PlanError::kUnreachableGoal);
  EXPECT_NE(found.failure.message.find("'there/top' cannot be entered"), std::string::npos) << found.failure.message;
  EXPECT_NE(found.failure.message.find("out of reach by at least"), std::string::npos) << found.failure.message;
  EXPECT_FALSE(found.failure.hint.empty());
}

TEST(Reasons, AFaceAloneHasNoTransitions) {
  const auto scene =
      prepared(truss::parse_truss("kind: truss\ndescription: plates\nfaces:\n"
                                  "  - {name: floor, polygon: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], normal: [0, 0, 1]}\n"
                                  "  - {name: shelf, polygon: [[0, 0, 3], [1, 0, 3], [1, 1, 3], [0, 1, 3]], normal: [0, 0, 1]}\n"));
  const Found found =
      plan(*scene, foothold_on(scene->truss, {0.5, 0.5, 0}, {0, 0, 0}), foothold_on(scene->truss, {0.5, 0.5, 3}, {0, 0, 0}));
  ASSERT_EQ(found.outcome, Outcome::kFailed);
  EXPECT_NE(found.failure.message.find("no transition footholds"), std::string::npos) << found.failure.message;
  EXPECT_NE(found.failure.message.find("'shelf'"), std::string::npos) << found.failure.message;
}

TEST(OneFace, TakesAsManyStridesAsTheBoundDemands) {
  const auto scene =
      prepared(truss::parse_truss("kind: truss\ndescription: floor\nfaces:\n"
                                  "  - {name: floor, polygon: [[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0]], normal: [0, 0, 1]}\n"));
  const StrideBounds bounds(robot());
  std::mt19937_64 random(31);
  int proved = 0;
  constexpr int kRoutes = 300;
  for (int i = 0; i < kRoutes; ++i) {
    const auto some = [&] {
      const double x = uniform(random, 0.1, 3.9), y = uniform(random, 0.1, 2.9);
      return foothold_on(scene->truss, {x, y, 0.0}, {0.0, 0.0, uniform(random, -180, 180)});
    };
    const Foothold start = some(), goal = some();
    const Found found = plan(*scene, start, goal);
    ASSERT_EQ(found.outcome, Outcome::kReached) << i << ": " << found.failure.message;
    expect_climbable(*scene, found.route);
    EXPECT_GE(found.cost, bounds.least(start, goal));
    proved += found.optimal ? 1 : 0;
  }
  EXPECT_GE(proved, 0.9 * kRoutes);
}

}  // namespace
}  // namespace foothold::hyrecro
