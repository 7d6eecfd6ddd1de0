// Algorithms 1 and 2 on one wide face, where their footholds can be worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "ground.hpp"
#include "hyrecro/paper/face_walk.hpp"

namespace foothold::hyrecro {
namespace {

constexpr const char* kWall = R"(
kind: truss
faces:
  - {name: wall, polygon: [[0, 0, 0], [4, 0, 0], [4, 2, 0], [0, 2, 0]], normal: [0, 0, 1]}
)";

const PreparedTruss& wall() {
  static const auto scene = prepared(kWall);
  return *scene;
}

Foothold on_wall(double x, double y, double degrees) {
  const double heading = degrees * std::numbers::pi / 180.0;
  return stand(wall(), {x, y, 0}, Vector3d::UnitZ(), {std::cos(heading), std::sin(heading), 0});
}

// World X and Y of a foothold.
Vector2d place(const Foothold& foothold) { return pose_of(wall().truss, foothold).translation().head<2>(); }

std::vector<Stride> walk(const Foothold& from, const Foothold& to, FaceRule rule = FaceRule::kPaper) {
  PaperOptions options;
  options.rule = rule;
  const auto strides = plan_face(robot(), wall(), from, to, options, {});
  EXPECT_TRUE(strides) << "the walk got stuck";
  if (!strides) return {};
  expect_stands(wall(), {from, *strides});
  return *strides;
}

TEST(Algorithm1, GoesStraightAheadByTheGreatestReachAndEndsFromTheOptimalCircle) {
  const double r_max = shared_workspace()->r_max(), r_opt = shared_workspace()->r_opt();
  // Five greatest reaches, then what is left but for the optimal one: farther than a sole that is turned across can be put.
  const double from = 0.3, left = 0.33, to = from + 5 * r_max + left + r_opt;
  const std::vector<Stride> strides = walk(on_wall(from, 1.0, 0), on_wall(to, 1.0, 90));
  ASSERT_EQ(strides.size(), 7U);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR((place(strides[k].to) - Vector2d(from + static_cast<double>(k + 1) * r_max, 1.0)).norm(), 0.0, 1e-6) << k;
    EXPECT_NEAR(strides[k].to.heading, on_wall(from, 1.0, 0).heading, 1e-6) << k;
  }
  EXPECT_NEAR((place(strides[5].to) - Vector2d(to - r_opt, 1.0)).norm(), 0.0, 0.0051);
  EXPECT_NEAR((place(strides[6].to) - Vector2d(to, 1.0)).norm(), 0.0, 1e-9);
}

TEST(Algorithm1, PutsAnAdditionalFootholdOnTheOptimalCircleWhenTheGoalIsTooNear) {
  for (const auto& [dx, degrees] : {std::pair{0.08, 0.0}, {0.05, 90.0}, {0.0, 90.0}, {0.0, 180.0}}) {
    const Foothold from = on_wall(2, 1, 0), to = on_wall(2 + dx, 1, degrees);
    const std::vector<Stride> strides = walk(from, to);
    ASSERT_EQ(strides.size(), 2U) << dx << " " << degrees;
    EXPECT_NEAR((place(strides[0].to) - place(to)).norm(), shared_workspace()->r_opt(), 0.0051) << dx << " " << degrees;
  }
}

TEST(Algorithm2, TakesTheReachablePositionNearestToTheCrossingTurnedAlongTheWay) {
  const WorkspaceOrder order(shared_workspace());
  const auto exact = make_exact(robot(), kClearance);
  JointSolutions solutions(robot(), wall(), *exact);
  PaperOptions options;
  const SafeGround ground(wall().truss.faces[0], options.safe_inset);
  const Foothold current = on_wall(1.0, 1.0, 30), goal = on_wall(3.0, 1.4, 0);
  const std::vector<Vector2d> way = ground.way(current.at, goal.at, FaceWay::kVisibility);
  const double reach = 0.35;
  const auto stride = next_best_foothold({robot(), wall(), order, solutions, options}, ground, way, current, reach);
  ASSERT_TRUE(stride);
  // The same by exhaustion over the whole grid.
  const PlanarWorkspace& workspace = *shared_workspace();
  const Vector2d best = crossing(way, current.at, reach);
  double least = 1e9;
  Foothold expected;
  for (int i = -workspace.extent(); i <= workspace.extent(); ++i)
    for (int j = -workspace.extent(); j <= workspace.extent(); ++j) {
      const Vector2d at = current.at + Eigen::Rotation2Dd(current.heading) * (workspace.position_step() * Vector2d(i, j));
      if ((at - best).norm() >= least) continue;
      const Vector2d u_best = (crossing(way, at, reach) - at).normalized();
      for (int k = 0; k < workspace.headings(); ++k) {
        const double heading = current.heading + k * workspace.heading_step();
        if (!workspace.reachable(i, j, k) || u_best.dot(Vector2d(std::cos(heading), std::sin(heading))) < 0.998) continue;
        least = (at - best).norm();
        expected = {current.face, at, heading};
      }
    }
  EXPECT_NEAR((stride->to.at - expected.at).norm(), 0.0, 1e-9);
  // Two headings 5 degrees apart may both pass; the nearer one is taken.
  EXPECT_LE(std::fabs(std::remainder(stride->to.heading - expected.heading, 2 * std::numbers::pi)),
            workspace.heading_step() + 1e-9);
}

TEST(Algorithm1, TakesAnotherGreatestReachIfTold) {
  PaperOptions options;
  options.r_max = 0.40;
  const auto strides = plan_face(robot(), wall(), on_wall(0.5, 1, 0), on_wall(2.5, 1, 0), options, {});
  ASSERT_TRUE(strides);
  EXPECT_NEAR((place(strides->front().to) - Vector2d(0.9, 1)).norm(), 0.0, 1e-6);
}

TEST(Algorithm1, HasNothingToDoWhereOneStrideSuffices) {
  EXPECT_EQ(walk(on_wall(1, 1, 0), on_wall(1.3, 1, 0)).size(), 1U);
  EXPECT_EQ(walk(on_wall(1, 1, 0), on_wall(1.3, 1, 0), FaceRule::kZhu).size(), 1U);
}

TEST(RuleOfZhu, NeverTakesLessStridesInTheOpenThanThePaperByMoreThanOne) {
  for (int k = 0; k < 12; ++k) {
    const Foothold from = on_wall(0.5, 1.0, 30.0 * k), to = on_wall(3.5, 1.2, 360.0 - 30.0 * k);
    const std::size_t paper = walk(from, to).size(), zhu = walk(from, to, FaceRule::kZhu).size();
    EXPECT_LE(paper, zhu + 1) << k;
  }
}

TEST(FaceWalk, NamesTheFaceThatIsTooNarrow) {
  const auto scene = prepared(R"(
kind: truss
faces:
  - {name: lath, polygon: [[0, 0, 0], [4, 0, 0], [4, 0.12, 0], [0, 0.12, 0]], normal: [0, 0, 1]}
)");
  const Foothold from = stand(*scene, {0.5, 0.06, 0}, Vector3d::UnitZ(), Vector3d::UnitX());
  const Foothold to = stand(*scene, {3.5, 0.06, 0}, Vector3d::UnitZ(), Vector3d::UnitX());
  const auto exact = make_exact(robot(), kClearance);
  // One stride needs no way inside a safe polygon.
  const Foothold near = stand(*scene, {0.8, 0.06, 0}, Vector3d::UnitZ(), Vector3d::UnitX());
  EXPECT_EQ(plan_paper(robot(), *scene, *exact, from, near, {}, {}, {}).route.strides.size(), 1U);
  const Found found = plan_paper(robot(), *scene, *exact, from, to, {}, {}, {});
  ASSERT_EQ(found.outcome, Found::Outcome::kFailed);
  EXPECT_NE(found.failure.message.find("lath"), std::string::npos) << found.failure.message;
  EXPECT_NE(found.failure.message.find("too narrow"), std::string::npos) << found.failure.message;
}

}  // namespace
}  // namespace foothold::hyrecro
