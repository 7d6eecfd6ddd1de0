// Requests to plans, each step judged as the host does.
#include <chrono>
#include <thread>

#include "planning.hpp"

namespace foothold::octopod {
namespace {

using Outcome = PlanReport::Outcome;

std::shared_ptr<const PreparedScene> ramps(const Parameters& values) {
  return shared_planner().prepare(shipped("terrain-ramps"), values);
}

double figure(const PlanReport& report, const std::string& name) {
  for (const Margin& margin : report.figures)
    if (margin.name == name) return margin.value;
  ADD_FAILURE() << "no figure " << name;
  return 0.0;
}

TEST(Planner, WalksToThePapersGoals) {
  const Parameters values = parameters();
  const auto scene = ramps(values);
  for (const Vector3d& goal : {kPaperA, kPaperB}) {
    Collector out;
    const PlanReport report = judged_plan(shared_planner(), request_between(kPaperStart, goal), values, *scene, out);
    ASSERT_EQ(report.outcome, Outcome::kReached) << report.message;
    EXPECT_TRUE(report.optimal);
    EXPECT_EQ(report.cost_unit, "m");
    EXPECT_EQ(figure(report, "unstable stances"), 0.0);
    EXPECT_LE(figure(report, "greatest critical friction"), 0.4);
    EXPECT_LT(figure(report, "greatest residual"), 1e-6);
    ASSERT_FALSE(out.steps.empty());
    EXPECT_NEAR(out.steps.back().cost, report.cost, 1e-9);
    for (const Step& step : out.steps) {
      EXPECT_EQ(step.placed.size(), 8u);
      EXPECT_EQ(step.after.joints.size(), std::size_t{kJoints});
    }
  }
}

TEST(Planner, SaysWhatIsNotSafeWhereStabilityIsOff) {
  const Parameters values = parameters({{"stability", "false"}});
  const auto scene = ramps(values);
  Collector out;
  const PlanReport report = judged_plan(shared_planner(), request_between(kPaperStart, kPaperB), values, *scene, out);
  ASSERT_EQ(report.outcome, Outcome::kReached) << report.message;
  EXPECT_NE(report.objective.find("STABILITY IS OFF"), std::string::npos) << report.objective;
  EXPECT_EQ(figure(report, "unstable stances") > 0.0, !report.message.empty());
  const PlanReport safe = shared_planner().plan(request_between(kPaperStart, kPaperB), parameters(), *ramps(parameters()), out);
  EXPECT_LE(report.cost, safe.cost + 1e-9);
}

TEST(Planner, NoMethodIsCheaperThanTheOptimalOne) {
  const Request request = request_between(kPaperStart, kPaperA);
  double costs[3];
  int k = 0;
  for (const char* method : {"optimal", "paper", "rrt"}) {
    const Parameters values = parameters({{"method", method}, {"samples", "3000"}});
    Collector out(7);
    const PlanReport report = judged_plan(shared_planner(), request, values, *ramps(values), out);
    ASSERT_EQ(report.outcome, Outcome::kReached) << method << ": " << report.message;
    EXPECT_LE(report.lower_bound, report.cost);
    EXPECT_EQ(report.optimal, k == 0) << method;
    costs[k++] = report.cost;
  }
  EXPECT_LE(costs[0], costs[1] + 1e-9);
  EXPECT_LE(costs[0], costs[2] + 1e-9);
}

TEST(Planner, TellsWhatIsInTheWay) {
  const Parameters values = parameters({{"friction", "0.05"}});
  Collector out;
  const PlanReport report = shared_planner().plan(request_between(kPaperStart, kPaperA), values, *ramps(values), out);
  EXPECT_EQ(report.outcome, Outcome::kFailed);
  EXPECT_TRUE(report.error == PlanError::kNoPath || report.error == PlanError::kUnreachableGoal);
  EXPECT_EQ(report.field, "goal.base.position");
  EXPECT_NE(report.message.find("needs friction"), std::string::npos) << report.message;
  EXPECT_GT(figure(report, "states of the cut"), 0.0);
  EXPECT_FALSE(report.hint.empty());
  EXPECT_TRUE(out.steps.empty());
}

// A flight of steps whose third riser is as high as the body.
TEST(Planner, NamesTheCutWhereNoRouteLeads) {
  const Parameters values = parameters();
  const auto scene = shared_planner().prepare(shipped("terrain-stairs"), values);
  Collector out;
  const PlanReport report = shared_planner().plan(request_between({-1.6, 0.0, 0.0}, {1.6, 0.0, 0.5289}), values, *scene, out);
  EXPECT_EQ(report.outcome, Outcome::kFailed);
  EXPECT_EQ(report.error, PlanError::kNoPath);
  EXPECT_NE(report.message.find("separate start and goal"), std::string::npos) << report.message;
  EXPECT_NE(report.message.find("a body touches the ground"), std::string::npos) << report.message;
  EXPECT_GT(figure(report, "states of the cut"), 0.0);
  EXPECT_TRUE(out.steps.empty());
}

TEST(Planner, GivesUpAtTheLimitOfStates) {
  const Parameters values = parameters({{"max_states", "5"}});
  Collector out;
  const PlanReport report = shared_planner().plan(request_between(kPaperStart, kPaperA), values, *ramps(values), out);
  EXPECT_EQ(report.outcome, Outcome::kFailed);
  EXPECT_EQ(report.error, PlanError::kSearchLimit);
  EXPECT_EQ(report.field, "parameters.max_states");
}

void expect_same(const std::vector<Step>& a, const std::vector<Step>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].label, b[k].label);
    EXPECT_EQ(a[k].cost, b[k].cost);
    EXPECT_EQ(a[k].after.joints, b[k].after.joints);
    EXPECT_TRUE(a[k].after.base.matrix() == b[k].after.base.matrix());
    for (std::size_t i = 0; i < a[k].placed.size(); ++i)
      EXPECT_TRUE(a[k].placed[i].frame.matrix() == b[k].placed[i].frame.matrix());
    for (std::size_t i = 0; i < a[k].attributes.size(); ++i) EXPECT_EQ(a[k].attributes[i].value, b[k].attributes[i].value);
    ASSERT_EQ(a[k].motion.size(), b[k].motion.size());
    for (std::size_t i = 0; i < a[k].motion.size(); ++i) EXPECT_EQ(a[k].motion[i].joints, b[k].motion[i].joints);
  }
}

TEST(Planner, GivesTheSameBytesForTheSameRequestWhateverWasPlannedBefore) {
  for (const char* method : {"optimal", "paper", "rrt"}) {
    const Parameters values = parameters({{"method", method}, {"samples", "3000"}});
    Collector first(7), second(7), warm_up(1);
    OctopodPlanner fresh(robot_file());
    const auto scene = fresh.prepare(shipped("terrain-ramps"), values);
    const PlanReport a = fresh.plan(request_between(kPaperStart, kPaperA), values, *scene, first);
    const auto used = ramps(values);
    shared_planner().plan(request_between(kPaperA, kPaperB), values, *used, warm_up);
    const PlanReport b = shared_planner().plan(request_between(kPaperStart, kPaperA), values, *used, second);
    EXPECT_EQ(a.cost, b.cost) << method;
    EXPECT_EQ(a.lower_bound, b.lower_bound) << method;
    expect_same(first.steps, second.steps);
  }
}

TEST(Planner, MovesFromStanceToStanceWhereTransitionsAreWanted) {
  const Parameters values = parameters({{"transitions", "true"}});
  const auto scene = shared_planner().prepare(shipped("terrain-ditch"), values);
  Collector out;
  const Request request = request_between({-1.5, -1.0, 0.0}, {-0.9, -1.0, 0.0});
  Posture before = shared_planner().start(request, values, *scene);
  const PlanReport report = judged_plan(shared_planner(), request, values, *scene, out);
  ASSERT_EQ(report.outcome, Outcome::kReached) << report.message;
  EXPECT_GT(figure(report, "least friction left in motion"), 0.0);
  ASSERT_FALSE(out.steps.empty());
  for (const Step& step : out.steps) {
    ASSERT_GT(step.motion.size(), 2u);
    EXPECT_EQ(step.motion.front().time, 0.0);
    for (std::size_t k = 0; k < kJoints; ++k) {
      EXPECT_NEAR(step.motion.front().joints[k], before.joints[k], 1e-9) << k;
      EXPECT_NEAR(step.motion.back().joints[k], step.after.joints[k], 1e-9) << k;
    }
    before = step.after;
  }
  Collector without;
  EXPECT_LE(shared_planner().plan(request, parameters(), *scene, without).cost, report.cost + 1e-9);
}

TEST(Planner, StopsWhenItIsTold) {
  const Parameters values = parameters({{"resolution", "0.02"}});
  const auto scene = ramps(values);
  std::stop_source source;
  Collector out;
  out.stop = source.get_token();
  source.request_stop();
  EXPECT_EQ(shared_planner().plan(request_between(kPaperStart, kPaperB), values, *scene, out).outcome, Outcome::kStopped);
  EXPECT_TRUE(out.steps.empty());
}

TEST(Planner, EndsWhenNoMoreStepsAreWanted) {
  const Parameters values = parameters();
  Collector out;
  out.most = 1;
  EXPECT_EQ(shared_planner().plan(request_between(kPaperStart, kPaperA), values, *ramps(values), out).outcome, Outcome::kStopped);
  EXPECT_EQ(out.steps.size(), 1u);
}

TEST(Planner, ShowsTheTerrainAndTheRobot) {
  const Parameters values = parameters();
  const auto scene = ramps(values);
  EXPECT_EQ(scene->shapes().size(), 42u);
  const Posture start = shared_planner().start(request_between(kPaperStart, kPaperA), values, *scene);
  EXPECT_EQ(shared_planner().shapes(start).size(), 20u);
}

}  // namespace
}  // namespace foothold::octopod
