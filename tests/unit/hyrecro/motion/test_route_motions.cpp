// Motions of whole routes, judged by the checker of steps as well.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fixtures.hpp"
#include "hyrecro/check/check.hpp"
#include "hyrecro/posture.hpp"
#include "hyrecro/reach/reachability.hpp"
#include "hyrecro/steps.hpp"

namespace foothold::hyrecro {
namespace {

using testing::shipped_model;

const truss::Truss& crossed_beams() {
  static const truss::Truss truss = truss::read_truss(FOOTHOLD_CONFIG_DIR "/scenes/truss-crossed-beams.yaml");
  return truss;
}

Foothold on(const char* face, double x, double y, double heading) {
  const auto& faces = crossed_beams().faces;
  for (std::size_t k = 0; k < faces.size(); ++k)
    if (faces[k].name == face) return {static_cast<int>(k), {x, y}, heading};
  ADD_FAILURE() << face;
  return {};
}

struct Walk {
  Route route;
  Coordinates start;  // both feet hold
};

// Over the footholds, the first of which the foot leaves that makes the first stride. Any joint solution that is free of
// collisions.
Walk walk_over(const Obstacles& obstacles, const std::vector<Foothold>& footholds) {
  Walk out;
  const std::unique_ptr<Reachability> exact = make_exact(shipped_model(), 0.005);
  const auto solution = [&](const Foothold& holds, const Foothold& placed) {
    const Isometry3d sole = pose_of(crossed_beams(), holds);
    const Reach reach = exact->reach(sole.inverse() * pose_of(crossed_beams(), placed), [&](const Coordinates& c) {
      return obstacles.free(bodies_at(shipped_model(), c, sole), 0.005);
    });
    EXPECT_TRUE(reach.reachable);
    return reach.coordinates.value_or(Coordinates{});
  };
  out.route.start = footholds[1];
  out.start = solution(footholds[1], footholds[0]);
  for (std::size_t k = 2; k < footholds.size(); ++k)
    out.route.strides.push_back({footholds[k], solution(footholds[k - 1], footholds[k])});
  return out;
}

// Every stride's motion by dense sampling, and the steps that it makes by the checker.
void judge(const Obstacles& obstacles, const Walk& walk, const RouteMotions& motions, const MotionOptions& options) {
  ASSERT_EQ(motions.failed, -1) << motions.reason;
  ASSERT_EQ(motions.motions.size(), walk.route.strides.size());
  Grip holding{Foot::kA, walk.route.start};
  Coordinates from = walk.start;
  Posture before = posture_of(shipped_model(), from, Foot::kA, pose_of(crossed_beams(), walk.route.start));
  before.stance = {to_contact(crossed_beams(), holding)};
  for (std::size_t k = 0; k < motions.motions.size(); ++k) {
    const Stride& stride = motions.route.strides[k];
    EXPECT_EQ(testing::fault_of(obstacles, pose_of(crossed_beams(), holding.at), from, stride.coordinates, true, options,
                                motions.motions[k], 1000),
              "")
        << "stride " << k;
    Step step = to_step(shipped_model(), crossed_beams(), holding, stride, 0.0);
    add_motion(shipped_model(), crossed_beams(), holding, motions.motions[k], before.joints, step);
    const StepVerdict verdict =
        check_step(shipped_model(), crossed_beams(), obstacles, CheckOptions{.clearance = options.clearance}, step, before);
    EXPECT_TRUE(verdict.accepted) << "stride " << k << ": " << verdict.reason;
    before = step.after;
    from = swapped(stride.coordinates);
    holding = {other(holding.foot), stride.to};
  }
}

// A convex transition from the long beam's side to its top, along it, a concave one up the short beam.
std::vector<Foothold> over_two_edges() {
  constexpr double quarter = 0.5 * std::numbers::pi;
  return {on("long/right", -0.95, 0.0, 0.0),         on("long/right", -0.8, 0.0, 0.0),
          on("long/right", -0.6375, 0.005, quarter), on("long/top.1", -0.5875, -0.005, -quarter),
          on("long/top.1", -0.288, -0.0128, -0.03),  on("long/top.1", 0.175, -0.025, 0.0),
          on("short/bottom.2", 0.28, 0.0, 0.0)};
}

TEST(RouteMotions, OverAConvexAndAConcaveEdgePassTheChecker) {
  const Obstacles obstacles(crossed_beams());
  const Walk walk = walk_over(obstacles, over_two_edges());
  const MotionOptions options;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::mt19937_64 random(seed);
    judge(obstacles, walk,
          plan_motions(shipped_model(), obstacles, crossed_beams(), walk.route, walk.start, true, options, random, {}), options);
  }
}

TEST(RouteMotions, RepeatThemselvesWithTheSameSeed) {
  const Obstacles obstacles(crossed_beams());
  const Walk walk = walk_over(obstacles, over_two_edges());
  std::mt19937_64 one(4), two(4);
  const RouteMotions a = plan_motions(shipped_model(), obstacles, crossed_beams(), walk.route, walk.start, true, {}, one, {}),
                     b = plan_motions(shipped_model(), obstacles, crossed_beams(), walk.route, walk.start, true, {}, two, {});
  ASSERT_EQ(a.motions.size(), b.motions.size());
  for (std::size_t k = 0; k < a.motions.size(); ++k) {
    EXPECT_EQ(a.motions[k].times, b.motions[k].times);
    EXPECT_EQ(joint_rows(shipped_model(), a.motions[k], Foot::kA, {}), joint_rows(shipped_model(), b.motions[k], Foot::kA, {}));
  }
}

TEST(RouteMotions, EndAtOnceWhenStopped) {
  const Obstacles obstacles(crossed_beams());
  const Walk walk = walk_over(obstacles, over_two_edges());
  std::mt19937_64 random(4);
  std::stop_source stop;
  stop.request_stop();
  const RouteMotions motions =
      plan_motions(shipped_model(), obstacles, crossed_beams(), walk.route, walk.start, true, {}, random, stop.get_token());
  EXPECT_GE(motions.failed, 0);
  EXPECT_EQ(motions.reason, "stopped");
  EXPECT_TRUE(motions.motions.empty());
}

TEST(RouteMotions, TellTheStrideWhoseFootCannotBeLifted) {
  const Obstacles obstacles(crossed_beams());
  // Straight over the edge, 0.07 m from it on both sides and 0.1 m apart: at the border of what can be reached.
  constexpr double quarter = 0.5 * std::numbers::pi;
  const Foothold side = on("long/right", -0.6, 0.005, quarter);
  Foothold top = on("long/top.1", 0.0, 0.0, 0.0);
  Isometry3d over = Isometry3d::Identity();
  over.linear() << 0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0;
  over.translation() << 0.07, -0.1, -0.07;
  const Isometry3d wanted = pose_of(crossed_beams(), side) * over;
  const Isometry3d in_face = crossed_beams().faces[static_cast<std::size_t>(top.face)].frame.inverse() * wanted;
  ASSERT_NEAR(in_face.translation().z(), 0.0, 1e-9);
  top.at = in_face.translation().head<2>();
  top.heading = std::atan2(in_face.linear()(1, 0), in_face.linear()(0, 0));
  const Walk walk = walk_over(obstacles, {on("long/right", -0.85, 0.0, 0.0), side, top});
  std::mt19937_64 random(2);
  const RouteMotions motions =
      plan_motions(shipped_model(), obstacles, crossed_beams(), walk.route, walk.start, true, {}, random, {});
  EXPECT_EQ(motions.failed, 0);
  EXPECT_NE(motions.reason.find("cannot be lifted"), std::string::npos) << motions.reason;
}

}  // namespace
}  // namespace foothold::hyrecro
