// Requests to plans: the paper's examples end to end, each step judged.
#include <gtest/gtest.h>

#include "fixtures.hpp"
#include "planner.hpp"

namespace foothold::xrobin {
namespace {

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
  XrobinPlanner planner(robot());
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
    EXPECT_DOUBLE_EQ(out.steps.back().cost, report.cost);
  }
}

TEST(Planner, DrawsBothBodiesAndBothPistonsWhereTheirPinsAre) {
  XrobinPlanner planner(robot());
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
