// Requests to plans: the paper's examples end to end, each step judged.
#include <gtest/gtest.h>

#include "fixtures.hpp"
#include "planner.hpp"

namespace foothold::xrobin {
namespace {

// One for all tests that do not ask what a fresh planner does: its tables take a third of a second.
XrobinPlanner& shared_planner() {
  static XrobinPlanner planner(robot());
  return planner;
}

// Plans and judges every step as the host does.
PlanReport plan(XrobinPlanner& planner, const Request& request, const Parameters& values, Collector& out) {
  const auto scene = planner.prepare({}, values);
  const PlanReport report = planner.plan(request, values, *scene, out);
  Posture before = planner.start(request, values, *scene);
  for (const Step& step : out.steps) {
    const StepVerdict verdict = planner.check(step, before, values, *scene);
    EXPECT_TRUE(verdict.accepted) << step.label << ": " << verdict.reason;
    before = step.after;
  }
  return report;
}

TEST(Planner, ReachesThePapersFirstTwoTargetsBetterThanThePaper) {
  XrobinPlanner& planner = shared_planner();
  const Parameters values = parameters();
  for (const auto& [target, error] : {std::pair{0.4, 0.275e-3}, std::pair{0.2, 0.0291e-3}}) {
    Collector out;
    const PlanReport report = plan(planner, request_to(target, target), values, out);
    EXPECT_EQ(report.outcome, PlanReport::Outcome::kReached);
    EXPECT_TRUE(report.optimal);
    EXPECT_LE(report.cost, error);
    EXPECT_LE(report.lower_bound, report.cost);
    EXPECT_GT(report.lower_bound, report.cost - 1e-9);
    ASSERT_EQ(out.steps.size(), 14u);
    const Vector3d end = out.steps.back().after.base.translation();
    EXPECT_NEAR(std::hypot(end.x() - target, end.y() - target), report.cost, 1e-12);
    EXPECT_NEAR(out.steps.back().cost, report.cost, 1e-12);
  }
}

TEST(Planner, GivesTheSameBytesForTheSameRequest) {
  for (const char* method : {"optimal", "fewest", "greedy"}) {
    const Parameters values = parameters({{"method", method}});
    Collector first, second;
    XrobinPlanner one(robot());
    XrobinPlanner other(robot());
    const PlanReport a = plan(one, request_to(0.31, -0.17), values, first);
    Collector warm_up;
    plan(other, request_to(-0.11, 0.2), values, warm_up);
    const PlanReport b = plan(other, request_to(0.31, -0.17), values, second);
    EXPECT_EQ(a.cost, b.cost);
    ASSERT_EQ(first.steps.size(), second.steps.size());
    for (std::size_t k = 0; k < first.steps.size(); ++k) {
      EXPECT_EQ(first.steps[k].label, second.steps[k].label);
      EXPECT_TRUE(first.steps[k].after.base.matrix() == second.steps[k].after.base.matrix());
    }
  }
}

TEST(Planner, FewestCountsItsCostInCycles) {
  XrobinPlanner& planner = shared_planner();
  Collector out;
  const PlanReport report = plan(planner, request_to(0.2, 0.2), parameters({{"method", "fewest"}, {"tolerance", "0.0006"}}), out);
  EXPECT_EQ(report.outcome, PlanReport::Outcome::kReached);
  EXPECT_EQ(report.cost_unit, "cycles");
  EXPECT_EQ(report.cost, 4.0);
  EXPECT_EQ(report.lower_bound, 4.0);
  EXPECT_TRUE(report.optimal);
  EXPECT_EQ(out.steps.size(), 8u);
  EXPECT_EQ(out.steps.back().cost, 4.0);
}

TEST(Planner, ApproachesAGoalBeyondTheCyclesAndGoesOnFromThere) {
  XrobinPlanner& planner = shared_planner();
  for (const auto& [method, tolerance] : {std::pair{"optimal", 0.001}, {"fewest", 0.001}, {"greedy", 0.005}}) {
    Collector out;
    const Parameters values = parameters({{"method", method}, {"tolerance", std::to_string(tolerance)}});
    const PlanReport report = plan(planner, request_to(1.0, 1.0), values, out);
    EXPECT_EQ(report.outcome, PlanReport::Outcome::kReached) << method << ": " << report.message;
    const Vector3d end = out.steps.back().after.base.translation();
    EXPECT_LE(std::hypot(end.x() - 1.0, end.y() - 1.0), tolerance) << method;
    EXPECT_GT(out.steps.size(), 28u) << method;
    EXPECT_LE(report.lower_bound, report.cost) << method;
  }
}

TEST(Planner, SaysThatAGoalIsBeyondAllCyclesAndHowFarItCame) {
  XrobinPlanner& planner = shared_planner();
  Collector out;
  const PlanReport report = plan(planner, request_to(1.0, 1.0), parameters({{"max_cycles", "7"}}), out);
  EXPECT_EQ(report.outcome, PlanReport::Outcome::kPartial);
  EXPECT_EQ(report.error, PlanError::kUnreachableGoal);
  EXPECT_EQ(report.field, "goal.base.position");
  // The paper's word for this goal ends 819.73 mm away.
  EXPECT_NEAR(report.cost, 0.74574, 1e-5);
  EXPECT_TRUE(report.optimal);
  ASSERT_EQ(out.steps.size(), 14u);
}

TEST(Planner, EndsInTheWantedHeading) {
  XrobinPlanner& planner = shared_planner();
  for (int eighth = -3; eighth <= 4; ++eighth) {
    Request request = request_to(0.15, 0.1);
    request.goal.any_orientation = false;
    const double wanted = eighth * std::numbers::pi / 4.0;
    request.goal.base->rotate(Eigen::AngleAxisd(wanted, Vector3d::UnitZ()));
    Collector out;
    const PlanReport report = plan(planner, request, parameters(), out);
    ASSERT_EQ(report.outcome, PlanReport::Outcome::kReached) << eighth;
    const Isometry3d end = out.steps.back().after.base;
    EXPECT_LE(std::abs(wrapped(std::atan2(end(1, 0), end(0, 0)) - wanted)), 0.0174533) << eighth;
  }
}

TEST(Planner, SaysWhichHeadingsThereAre) {
  XrobinPlanner& planner = shared_planner();
  Request request = request_to(0.15, 0.1);
  request.goal.any_orientation = false;
  request.goal.base->rotate(Eigen::AngleAxisd(0.3, Vector3d::UnitZ()));
  Collector out;
  const PlanReport report = plan(planner, request, parameters(), out);
  EXPECT_EQ(report.outcome, PlanReport::Outcome::kFailed);
  EXPECT_EQ(report.error, PlanError::kUnreachableGoal);
  EXPECT_EQ(report.field, "goal.base.orientation");
  EXPECT_TRUE(out.steps.empty());
}

TEST(Planner, StandsStillWhenTheGoalIsWhereItStands) {
  XrobinPlanner& planner = shared_planner();
  Collector out;
  const PlanReport report = plan(planner, request_to(0.0, 0.0), parameters(), out);
  EXPECT_EQ(report.outcome, PlanReport::Outcome::kReached);
  EXPECT_TRUE(out.steps.empty());
  EXPECT_EQ(report.cost, 0.0);
}

TEST(Planner, PlansFromWhereTheRobotStands) {
  XrobinPlanner& planner = shared_planner();
  Request request = request_to(-0.2, 0.9);
  Isometry3d at = Isometry3d(Eigen::Translation3d(-0.3, 0.7, 0.0));
  at.rotate(Eigen::AngleAxisd(1.1, Vector3d::UnitZ()));
  request.start.base = at;
  Collector out;
  const PlanReport report = plan(planner, request, parameters({{"start_configuration", "6"}}), out);
  EXPECT_EQ(report.outcome, PlanReport::Outcome::kReached);
  EXPECT_LT(report.cost, 0.3e-3);
}

TEST(Planner, StopsWhenAsked) {
  XrobinPlanner& planner = shared_planner();
  const Parameters values = parameters();
  const auto scene = planner.prepare({}, values);
  std::stop_source stop;
  stop.request_stop();
  Collector out;
  out.stop = stop.get_token();
  EXPECT_EQ(planner.plan(request_to(0.4, 0.4), values, *scene, out).outcome, PlanReport::Outcome::kStopped);
  EXPECT_TRUE(out.steps.empty());
}

TEST(Planner, EndsWhenAStepIsNotWanted) {
  class Refusing final : public PlanContext {
   public:
    bool emit(Step) override { return ++emitted < 3; }
    int emitted = 0;
  } out;
  XrobinPlanner& planner = shared_planner();
  const Parameters values = parameters();
  EXPECT_EQ(planner.plan(request_to(0.4, 0.4), values, *planner.prepare({}, values), out).outcome, PlanReport::Outcome::kStopped);
  EXPECT_EQ(out.emitted, 3);
}

TEST(Planner, DrawsBothBodiesAndBothPistonsWhereTheirPinsAre) {
  XrobinPlanner& planner = shared_planner();
  const Parameters values = parameters();
  Collector out;
  plan(planner, request_to(0.2, 0.1), values, out);
  for (const Step& step : out.steps) {
    const std::vector<Shape> shapes = planner.shapes(step.after);
    ASSERT_EQ(shapes.size(), 4u);
    for (const std::size_t piston : {0u, 1u}) {
      const Shape& capsule = shapes[2 + piston];
      EXPECT_NEAR(capsule.size.z(), step.after.joints[piston], 1e-9);
      // Each end is a pin of one of the bodies: on body A at +-b, on body B at +-p of its frame.
      const Vector3d on_a = capsule.pose * Vector3d(0, 0, -0.5 * capsule.size.z());
      const Vector3d on_b = capsule.pose * Vector3d(0, 0, 0.5 * capsule.size.z());
      const Vector3d in_a = shapes[0].pose.inverse() * on_a;
      const Vector3d in_b = shapes[1].pose.inverse() * on_b;
      EXPECT_NEAR(in_a.x(), piston == 0 ? -0.01859 : 0.01859, 1e-9);
      EXPECT_NEAR(in_a.y(), 0.0, 1e-9);
      EXPECT_NEAR(in_b.x(), piston == 0 ? 0.10131 : -0.10131, 1e-9);
      EXPECT_NEAR(in_b.y(), 0.0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace foothold::xrobin
