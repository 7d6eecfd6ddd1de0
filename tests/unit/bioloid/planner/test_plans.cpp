// Whole plans: every step passes check(), the robot arrives where it was sent, and the report says how good that is.
#include "../planning.hpp"

namespace foothold::bioloid::testing {
namespace {

double from_goal(const Step& last, const Isometry3d& goal) {
  Vector3d middle = Vector3d::Zero();
  for (const Contact& contact : last.after.stance) middle += 0.5 * contact.frame.translation();
  return (middle - goal.translation()).norm();
}

TEST(Plans, WalkAMetreInTwentyOneProvedPlacements) {
  BioloidPlanner& planner = shared_planner();
  const auto floor = planner.prepare({}, parameters());
  Collector out;
  const Request request = walk_request(on_floor(0, 0, 0), on_floor(1, 0, 0));
  const PlanReport report = judged_plan(planner, request, parameters(), *floor, out);
  ASSERT_EQ(report.outcome, PlanReport::Outcome::kReached) << report.message;
  EXPECT_TRUE(report.optimal);
  EXPECT_EQ(report.cost, 21.0);
  EXPECT_EQ(report.lower_bound, 21.0);
  ASSERT_EQ(out.steps.size(), 21u);
  EXPECT_LT(from_goal(out.steps.back(), *request.goal.base), 1e-9);
  for (const Step& step : out.steps) {
    EXPECT_EQ(step.placed.size(), 1u);
    EXPECT_EQ(step.after.stance.size(), 2u);
    EXPECT_GT(step.motion.size(), 50u);
  }
}

TEST(Plans, ArriveEverywhereOnAnOpenFloor) {
  BioloidPlanner& planner = shared_planner();
  const auto floor = planner.prepare({}, parameters());
  std::mt19937_64 random(11);
  const auto uniform = [&](double most) { return std::uniform_real_distribution<double>(-most, most)(random); };
  int proved = 0;
  const Parameters values = parameters({{"proof_nodes", "30000"}});
  for (int k = 0; k < 8; ++k) {
    Collector out;
    const Request request =
        walk_request(on_floor(uniform(1), uniform(1), uniform(3.1)), on_floor(uniform(0.4), uniform(0.4), uniform(3.1)));
    const PlanReport report = judged_plan(planner, request, values, *floor, out);
    ASSERT_EQ(report.outcome, PlanReport::Outcome::kReached) << k << ": " << report.message;
    EXPECT_LT(from_goal(out.steps.back(), *request.goal.base), 1e-9) << k;
    EXPECT_LE(report.lower_bound, report.cost);
    EXPECT_LE(report.cost, report.lower_bound + 7) << k;
    proved += report.optimal ? 1 : 0;
  }
  EXPECT_GE(proved, 3) << "where the proof does not end in time the bound says so";
}

TEST(Plans, BeginFromTheStandingZeroPose) {
  BioloidPlanner& planner = shared_planner();
  const auto floor = planner.prepare({}, parameters());
  Request request = walk_request(Isometry3d(Eigen::Translation3d(0, 0, 0.2105)), on_floor(0.1, 0, 0));
  request.start.joints.assign(kJoints, 0.0);
  Collector out;
  const PlanReport report = judged_plan(planner, request, parameters(), *floor, out);
  ASSERT_EQ(report.outcome, PlanReport::Outcome::kReached) << report.message;
  EXPECT_TRUE(out.steps.front().placed.empty()) << "it takes the posture to walk in first";
  EXPECT_EQ(out.steps.size(), static_cast<std::size_t>(report.cost) + 1);
}

TEST(Plans, GoAmongTheShippedObstacles) {
  BioloidPlanner& planner = shared_planner();
  const auto floor = planner.prepare(test::shipped("floor-obstacles"), parameters());
  Collector out;
  const Request request = walk_request(on_floor(0, 0, 0), on_floor(0.9, 0.05, 0));
  const PlanReport report = judged_plan(planner, request, parameters(), *floor, out);
  ASSERT_EQ(report.outcome, PlanReport::Outcome::kReached) << report.message;
  EXPECT_GE(report.lower_bound, 20.0);
  EXPECT_LE(report.cost, report.lower_bound + 3.0);
}

TEST(Plans, SayWhatIsInTheWay) {
  BioloidPlanner& planner = shared_planner();
  const auto floor = planner.prepare(test::shipped("floor-obstacles"), parameters());
  Collector out;
  const PlanReport report = planner.plan(walk_request(on_floor(0, 0, 0), on_floor(0.44, -0.15, 0)), parameters(), *floor, out);
  EXPECT_EQ(report.outcome, PlanReport::Outcome::kFailed);
  EXPECT_EQ(report.error, PlanError::kUnreachableGoal);
  EXPECT_EQ(report.field, "goal.base.position");
  EXPECT_NE(report.message.find("brick"), std::string::npos) << report.message;
  EXPECT_TRUE(out.steps.empty());
}

TEST(Plans, StopWhenNothingMoreIsWanted) {
  BioloidPlanner& planner = shared_planner();
  const auto floor = planner.prepare({}, parameters());
  Collector out;
  out.most = 3;
  const PlanReport report = planner.plan(walk_request(on_floor(0, 0, 0), on_floor(1, 0, 0)), parameters(), *floor, out);
  EXPECT_EQ(report.outcome, PlanReport::Outcome::kStopped);
  EXPECT_EQ(out.steps.size(), 3u);
}

TEST(Plans, AreTheSameAgain) {
  BioloidPlanner& planner = shared_planner();
  const auto floor = planner.prepare({}, parameters());
  const Request request = walk_request(on_floor(0, 0, 0), on_floor(0.2, 0.1, 0.5));
  Collector first(5), second(5);
  planner.plan(request, parameters(), *floor, first);
  planner.plan(request, parameters(), *floor, second);
  ASSERT_EQ(first.steps.size(), second.steps.size());
  for (std::size_t k = 0; k < first.steps.size(); ++k) {
    ASSERT_EQ(first.steps[k].motion.size(), second.steps[k].motion.size());
    for (std::size_t p = 0; p < first.steps[k].motion.size(); ++p)
      EXPECT_EQ(first.steps[k].motion[p].joints, second.steps[k].motion[p].joints);
  }
}

}  // namespace
}  // namespace foothold::bioloid::testing
