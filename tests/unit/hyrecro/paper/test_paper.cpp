// Whole routes: on one beam, on the paper's crossed beams, round corners; and why there is none.
#include <gtest/gtest.h>

#include <cmath>

#include "ground.hpp"
#include "hyrecro/paper/transition_search.hpp"

namespace foothold::hyrecro {
namespace {

constexpr const char* kBeam = R"(
kind: truss
beams:
  - {name: beam, from: [0, 0, 0], to: [1.6, 0, 0], profile: {width: 0.3, height: 0.3}, up: [0, 0, 1]}
)";

Found plan(const PreparedTruss& scene, const Foothold& from, const Foothold& to, const PaperOptions& options = {},
           PaperTimes* times = nullptr) {
  const auto exact = make_exact(robot(), kClearance);
  return plan_paper(robot(), scene, *exact, from, to, options, {}, {}, times);
}

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

TEST(MethodPaper, ClimbsRoundTheEdgeOfABeam) {
  const auto scene = prepared(kBeam);
  const Foothold from = stand(*scene, {0.4, 0.0, 0.15}, kZ, kX), to = stand(*scene, {1.2, 0.15, 0.0}, kY, kX);
  PaperTimes times;
  const Found found = plan(*scene, from, to, {}, &times);
  ASSERT_EQ(found.outcome, Found::Outcome::kReached) << found.failure.message;
  expect_stands(*scene, found.route);
  EXPECT_EQ(transitions_of(found.route), 1U);
  EXPECT_EQ(found.route.strides.back().to.face, to.face);
  EXPECT_EQ(found.cost, static_cast<double>(found.route.strides.size()));
  EXPECT_FALSE(found.optimal);
  EXPECT_GT(times.ppt, 0.0);
  EXPECT_FALSE(times.ppi.empty());
}

TEST(MethodPaper, CrossesThreeFacesOnTheCrossedBeams) {
  const auto scene = shipped("truss-crossed-beams");
  const Foothold from = stand(*scene, {0.2, -0.075, 0.0}, -kY, kX), to = stand(*scene, {1.425, 0.0, 0.43}, -kX, kY);
  for (const FaceRule rule : {FaceRule::kPaper, FaceRule::kZhu}) {
    PaperOptions options;
    options.rule = rule;
    PaperTimes times;
    const Found found = plan(*scene, from, to, options, &times);
    ASSERT_EQ(found.outcome, Found::Outcome::kReached) << found.failure.message;
    expect_stands(*scene, found.route);
    EXPECT_EQ(transitions_of(found.route), 2U);
    EXPECT_EQ(times.ppi.size(), 3U);
    // As on the last face of the paper's Figure 10: the goal is too near to where the face is entered, and an additional foothold
    // is put on the circle of r_opt round it.
    ASSERT_GE(found.route.strides.size(), 3U);
    const std::size_t last = found.route.strides.size() - 1;
    EXPECT_EQ(found.route.strides[last - 2].to.face, to.face);
    EXPECT_LT((found.route.strides[last - 2].to.at - to.at).norm(), shared_workspace()->r_opt());
    EXPECT_NEAR((found.route.strides[last - 1].to.at - to.at).norm(), shared_workspace()->r_opt(), 0.01);
    RecordProperty(rule == FaceRule::kPaper ? "strides" : "strides_zhu", static_cast<int>(found.route.strides.size()));
    std::printf("crossed beams, rule of %s: %zu strides\n", rule == FaceRule::kPaper ? "the paper" : "Zhu",
                found.route.strides.size());
  }
}

// With answers that other requests left behind, and with its own when asked again.
TEST(MethodPaper, AnswersTheSameWithWhatIsKeptAsWithout) {
  const auto scene = shipped("truss-crossed-beams"), fresh = shipped("truss-crossed-beams");
  const Foothold from = stand(*scene, {0.2, -0.075, 0.0}, -kY, kX), to = stand(*scene, {1.425, 0.0, 0.43}, -kX, kY);
  PaperOptions keeping;
  keeping.keeps = true;
  const Found wanted = plan(*fresh, from, to);
  ASSERT_EQ(plan(*scene, to, from, keeping).outcome, Found::Outcome::kReached);
  for (int round = 0; round < 2; ++round) {
    const Found found = plan(*scene, from, to, keeping);
    ASSERT_EQ(found.outcome, Found::Outcome::kReached);
    ASSERT_EQ(found.route.strides.size(), wanted.route.strides.size());
    for (std::size_t k = 0; k < found.route.strides.size(); ++k) {
      EXPECT_EQ(found.route.strides[k].to.at, wanted.route.strides[k].to.at);
      EXPECT_EQ(found.route.strides[k].to.heading, wanted.route.strides[k].to.heading);
      EXPECT_EQ(found.route.strides[k].coordinates.hip, wanted.route.strides[k].coordinates.hip);
    }
  }
}

TEST(MethodPaper, TurnsTheCornersOfTheZigzagWithBothRules) {
  const auto scene = shipped("truss-turns");
  const Foothold from = stand(*scene, {0.15, 0.15, 0}, kZ, kX), to = stand(*scene, {1.8, 0.162, 0}, kZ, -kY);
  std::size_t strides[2] = {0, 0};
  for (const FaceRule rule : {FaceRule::kPaper, FaceRule::kZhu}) {
    PaperOptions options;
    options.rule = rule;
    const Found found = plan(*scene, from, to, options);
    ASSERT_EQ(found.outcome, Found::Outcome::kReached) << found.failure.message;
    expect_stands(*scene, found.route);
    EXPECT_EQ(transitions_of(found.route), 0U);
    strides[rule == FaceRule::kZhu] = found.route.strides.size();
  }
  std::printf("zigzag: rule of the paper %zu strides, of Zhu %zu\n", strides[0], strides[1]);
  EXPECT_LE(strides[0], strides[1]);
}

// All routes over a coarse beam, by Floyd's algorithm on the same graph built without the search.
TEST(TransitionSearch, FindsTheShortestRouteOfTheGraph) {
  const auto scene = prepared(kBeam, 0.4);
  const Foothold from = stand(*scene, {0.4, 0.0, 0.15}, kZ, kX), to = stand(*scene, {1.2, 0.0, -0.15}, -kZ, kX);
  std::vector<Foothold> nodes{from, to};
  for (const TransitionFoothold& one : scene->transitions.all()) nodes.push_back(one.foothold);
  const std::size_t n = nodes.size();
  std::vector<double> length(n * n, std::numeric_limits<double>::infinity());
  const auto exact = make_exact(robot(), kClearance);
  JointSolutions solutions(robot(), *scene, *exact);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b) {
      const Isometry3d one = pose_of(scene->truss, nodes[a]), other = pose_of(scene->truss, nodes[b]);
      const double far = (one.translation() - other.translation()).norm();
      if (nodes[a].face == nodes[b].face || (far < 0.9 && solutions.solve(one, other).reachable)) length[a * n + b] = far;
    }
  for (std::size_t via = 0; via < n; ++via)
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b)
        length[a * n + b] = std::min(length[a * n + b], length[a * n + via] + length[via * n + b]);
  const GlobalRoute route = search_transitions(*scene, solutions, from, to, greatest_reach(robot()), {});
  ASSERT_EQ(route.outcome, GlobalRoute::Outcome::kReached);
  double ours = 0.0;
  for (std::size_t k = 1; k < route.waypoints.size(); ++k)
    ours += (pose_of(scene->truss, route.waypoints[k].foothold).translation() -
             pose_of(scene->truss, route.waypoints[k - 1].foothold).translation())
                .norm();
  EXPECT_NEAR(ours, length[1], 1e-9);
  EXPECT_EQ(route.waypoints.front().foothold.face, from.face);
  EXPECT_EQ(route.waypoints.back().foothold.face, to.face);
}

// A network that takes everything near for reachable.
class Gullible final : public Reachability {
 public:
  Reach reach(const Isometry3d& pose, const Admit&) override { return {pose.translation().norm() < 0.9, std::nullopt}; }
};

TEST(MethodPaper, SendsANetworksWrongPositivesSoThatACheckCanRefuseThem) {
  const auto scene = prepared(kBeam);
  const Foothold from = stand(*scene, {0.4, 0.0, 0.15}, kZ, kX), to = stand(*scene, {1.2, 0.15, 0.0}, kY, kX);
  Gullible network;
  const Found found = plan_paper(robot(), *scene, network, from, to, {}, {}, {});
  ASSERT_EQ(found.outcome, Found::Outcome::kReached) << found.failure.message;
  Foothold holding = found.route.start;
  std::size_t wrong = 0;
  for (const Stride& stride : found.route.strides) {
    EXPECT_TRUE(within_limits(robot(), stride.coordinates));
    const Isometry3d reached = pose_of(scene->truss, holding) * forward(robot(), stride.coordinates);
    wrong += (reached.translation() - pose_of(scene->truss, stride.to).translation()).norm() > 1e-6;
    holding = stride.to;
  }
  EXPECT_GE(wrong, 1U);
  EXPECT_LT(wrong, found.route.strides.size()) << "what is reachable is reached";
}

TEST(MethodPaper, HasNoStrideFromAPlaceToItself) {
  const auto scene = prepared(kBeam);
  const Foothold from = stand(*scene, {0.4, 0.0, 0.15}, kZ, kX);
  const Found found = plan(*scene, from, from);
  ASSERT_EQ(found.outcome, Found::Outcome::kReached);
  EXPECT_TRUE(found.route.strides.empty());
}

TEST(MethodPaper, NamesTheFaceThatIsOutOfReach) {
  const auto scene = prepared(R"(
kind: truss
beams:
  - {name: near, from: [0, 0, 0], to: [1, 0, 0], profile: {width: 0.2, height: 0.2}, up: [0, 0, 1]}
  - {name: far, from: [5, 0, 0], to: [6, 0, 0], profile: {width: 0.2, height: 0.2}, up: [0, 0, 1]}
)");
  const Found found = plan(*scene, stand(*scene, {0.5, 0, 0.1}, kZ, kX), stand(*scene, {5.5, 0, 0.1}, kZ, kX));
  ASSERT_EQ(found.outcome, Found::Outcome::kFailed);
  EXPECT_EQ(found.failure.error, PlanError::kUnreachableGoal);
  EXPECT_EQ(found.failure.field, "goal");
  EXPECT_NE(found.failure.message.find("far/top cannot be entered"), std::string::npos) << found.failure.message;
  EXPECT_NE(found.failure.message.find("apart"), std::string::npos) << found.failure.message;
}

TEST(MethodPaper, SaysThatASceneHasNoTransitions) {
  const auto scene = prepared(R"(
kind: truss
faces:
  - {name: one, polygon: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], normal: [0, 0, 1]}
  - {name: two, polygon: [[3, 0, 0], [4, 0, 0], [4, 1, 0], [3, 1, 0]], normal: [0, 0, 1]}
)");
  const Found found = plan(*scene, stand(*scene, {0.5, 0.5, 0}, kZ, kX), stand(*scene, {3.5, 0.5, 0}, kZ, kX));
  ASSERT_EQ(found.outcome, Found::Outcome::kFailed);
  EXPECT_NE(found.failure.message.find("no transition footholds"), std::string::npos) << found.failure.message;
}

TEST(MethodPaper, NamesWhatBlocksTheNearestTransition) {
  // A beam in a sleeve of plates all round that leaves no room beyond its top.
  const auto scene = prepared(R"(
kind: truss
beams:
  - {name: beam, from: [0, 0, 0], to: [1.6, 0, 0], profile: {width: 0.3, height: 0.3}, up: [0, 0, 1]}
  - {name: left guard, from: [-0.5, 0.4, -0.2], to: [2.1, 0.4, -0.2], profile: {width: 0.1, height: 1.2}, up: [0, 0, 1]}
  - {name: right guard, from: [-0.5, -0.4, -0.2], to: [2.1, -0.4, -0.2], profile: {width: 0.1, height: 1.2}, up: [0, 0, 1]}
  - {name: begin guard, from: [-0.3, -0.35, -0.2], to: [-0.3, 0.35, -0.2], profile: {width: 0.1, height: 1.2}, up: [0, 0, 1]}
  - {name: end guard, from: [1.9, -0.35, -0.2], to: [1.9, 0.35, -0.2], profile: {width: 0.1, height: 1.2}, up: [0, 0, 1]}
)",
                              0.4);
  const Found found = plan(*scene, stand(*scene, {0.8, 0, 0.15}, kZ, kX), stand(*scene, {0.8, 0.15, 0.0}, kY, kX));
  ASSERT_EQ(found.outcome, Found::Outcome::kFailed);
  EXPECT_NE(found.failure.message.find("is blocked: "), std::string::npos) << found.failure.message;
  EXPECT_NE(found.failure.message.find("guard"), std::string::npos) << found.failure.message;
}

TEST(MethodPaper, StopsWhenAskedTo) {
  const auto scene = prepared(kBeam);
  const Foothold from = stand(*scene, {0.4, 0.0, 0.15}, kZ, kX), to = stand(*scene, {1.2, 0.15, 0.0}, kY, kX);
  const auto exact = make_exact(robot(), kClearance);
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(plan_paper(robot(), *scene, *exact, from, to, {}, source.get_token(), {}).outcome, Found::Outcome::kStopped);
  int seen = 0;
  const auto once = [&](const Stride&) { return ++seen < 2; };
  EXPECT_EQ(plan_paper(robot(), *scene, *exact, from, to, {}, {}, once).outcome, Found::Outcome::kStopped);
  EXPECT_EQ(seen, 2);
}

}  // namespace
}  // namespace foothold::hyrecro
