// The stochastic method in nine joints: a single support of the paper's step.
#include <gtest/gtest.h>

#include "bioloid/paper/nine_trials.hpp"
#include "nine_cases.hpp"
#include "spaces.hpp"

namespace foothold::bioloid::paper::testing {
namespace {

using bioloid::testing::kCarried;
using bioloid::testing::kDegree;
using bioloid::testing::kOffGround;
using bioloid::testing::nine_case;
using bioloid::testing::NineCase;
using bioloid::testing::shipped_model;

struct Nine {
  explicit Nine(double lift, NineOptions options = {}) : shown(nine_case(lift)), judge(shipped_model(), {}) {
    space = nine_space(shipped_model(), judge, shown.support, shown.from, shown.to, options);
    start = at(shown.from);
    goal = at(shown.to);
  }
  Point at(const Joints& joints) const { return nine_point(shipped_model(), shown.support.foot, joints, space.dimension()); }
  Joints joints(const Point& point) const {
    Joints out;
    EXPECT_TRUE(joints_at(shipped_model(), shown.support.foot, point, 0.0, out));
    return out;
  }

  NineCase shown;
  Judge judge;
  Space space;
  Point start, goal;
};

TEST(NineJoints, AreAllJointsOfTheSupport) {
  const Nine nine(kCarried);
  EXPECT_EQ(nine.space.dimension(), 9);
  EXPECT_LT((nine.joints(nine.start) - nine.shown.from).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((nine.joints(nine.goal) - nine.shown.to).cwiseAbs().maxCoeff(), 1e-9);
  const Point from = nine.space.place(nine.start), to = nine.space.place(nine.goal);
  EXPECT_LT((to - from - point({0.1, 0.0, 0.0})).norm(), 1e-9);
}

TEST(NineJoints, ACarriedSoleGoesStraightByTheDeterministicRules) {
  const Nine nine(kCarried);
  std::mt19937_64 random(1);
  const Plan found = plan(nine.space, nine.start, nine.goal, {}, random);
  ASSERT_EQ(found.ending, Ending::kReached);
  const double most = ((nine.goal - nine.start).cwiseAbs().array() / nine.space.step.array()).maxCoeff();
  EXPECT_EQ(found.iterations, static_cast<std::size_t>(std::ceil(most)));
  EXPECT_EQ(found.movements(), found.iterations);
}

// From the ground to the ground the straight way drags the sole: detours and best approaches have to find another one.
TEST(NineJoints, FromGroundToGroundTheRandomRulesFindAWay) {
  Nine nine(kOffGround, {.step = kDegree});
  std::mt19937_64 random(2);
  const auto all = trials(nine.space, nine.start, nine.goal, {.iterations = 100'000}, 4,
                          balance_error(shipped_model(), nine.judge, nine.shown.support, 0.0), random);
  int reached = 0;
  for (const Trial& trial : all) {
    if (trial.plan.ending != Ending::kReached) continue;
    ++reached;
    const auto& path = trial.plan.path;
    EXPECT_EQ(path.front(), nine.start);
    EXPECT_EQ(path.back(), nine.goal);
    EXPECT_GT(trial.plan.iterations, trial.plan.movements());
    double highest = 0.0;
    for (std::size_t k = 0; k < path.size(); ++k) {
      const Joints joints = nine.joints(path[k]);
      EXPECT_EQ(nine.judge.posture(joints, nine.shown.support), Fault::kNone);
      EXPECT_GE(nine.space.place(path[k]).z(), 0.0);
      highest = std::max(highest, nine.space.place(path[k]).z());
      if (k > 0) {
        EXPECT_TRUE(nine.space.joins(path[k - 1], path[k])) << k;
      }
    }
    EXPECT_GT(highest, 0.001) << "it was lifted";
    EXPECT_GT(trial.mean_error, 0.0);
    EXPECT_LT(trial.mean_error, 0.05);
    EXPECT_GT(trial.error_variance, 0.0);
  }
  EXPECT_GE(reached, 2);
}

TEST(NineJoints, TheBestOfSeveralTrialsIsAMotionOfAllJoints) {
  const NineCase shown = nine_case(kOffGround);
  Judge judge(shipped_model(), {});
  std::mt19937_64 random(3);
  const NineTrials found = nine_trials(shipped_model(), judge, shown.support, shown.from, shown.to, {.step = kDegree},
                                       {.iterations = 100'000}, 4, Choice::kLeastError, random);
  ASSERT_EQ(found.trials.size(), 4u);
  ASSERT_TRUE(found.best);
  for (const Trial& trial : found.trials) {
    if (trial.plan.ending == Ending::kReached) {
      EXPECT_GE(trial.mean_error, found.trials[*found.best].mean_error);
    }
  }
  EXPECT_EQ(found.postures.size(), found.trials[*found.best].plan.path.size());
  EXPECT_LT((found.postures.front() - shown.from).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((found.postures.back() - shown.to).cwiseAbs().maxCoeff(), 1e-9);
  for (const Joints& joints : found.postures) EXPECT_EQ(judge.posture(joints, shown.support), Fault::kNone);
}

TEST(NineJoints, BetweenPosturesThatAreNotValidThereAreNoTrials) {
  const NineCase shown = nine_case(kCarried);
  Judge judge(shipped_model(), {});
  Joints falls = shown.to;
  falls[static_cast<int>(leg_joint(Side::kRight, 1))] += 0.5;  // leans sideways
  std::mt19937_64 random(3);
  const NineTrials found =
      nine_trials(shipped_model(), judge, shown.support, shown.from, falls, {}, {}, 4, Choice::kLeastError, random);
  EXPECT_TRUE(found.trials.empty());
  EXPECT_FALSE(found.best);
}

TEST(NineJoints, WithAnotherHeadingThereAreTen) {
  const NineCase shown = nine_case(kCarried);
  Joints turned = shown.to;
  Judge judge(shipped_model(), {});
  Point ten = nine_point(shipped_model(), Side::kRight, turned, 10);
  ten[9] += 0.2;
  ASSERT_TRUE(joints_at(shipped_model(), Side::kRight, ten, 0.0, turned));
  const Space space = nine_space(shipped_model(), judge, shown.support, shown.from, turned);
  ASSERT_EQ(space.dimension(), 10);
  std::mt19937_64 random(1);
  const Plan found = plan(space, nine_point(shipped_model(), Side::kRight, shown.from, 10),
                          nine_point(shipped_model(), Side::kRight, turned, 10), {}, random);
  ASSERT_EQ(found.ending, Ending::kReached);
  EXPECT_NEAR(found.path.back()[9] - found.path.front()[9], 0.2, 1e-9);
}

}  // namespace
}  // namespace foothold::bioloid::paper::testing
