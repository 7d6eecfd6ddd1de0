// Walks among obstacles: soles off them, over low ones, round high ones; the fewest placements still.
#include <gtest/gtest.h>

#include "../robot.hpp"
#include "bioloid/steps/walk.hpp"

namespace foothold::bioloid::testing {
namespace {

Prism box(const char* name, double x0, double x1, double y0, double y1, double height) {
  return {name, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, height};
}

struct Course {
  explicit Course(std::vector<Prism> obstacles, const GaitOptions& options = {})
      : prisms(std::move(obstacles)), gait(shipped_model(), options), walker(shipped_model(), gait, {}, prisms) {}
  Walk to(const PlanarPose& goal) {
    std::mt19937_64 random(1);
    Feet feet;
    for (const Side side : {Side::kRight, Side::kLeft}) feet.of(side) = sole_at(side, {}, walker.half_spacing());
    return walker.walk(feet, {goal, false}, random, {});
  }
  std::vector<Prism> prisms;
  Gait gait;
  Walker walker;
};

TEST(Walks, TakeTwentyOneStepsForAMetre) {
  const Walk walk = Course({}).to({1.0, 0.0, 0.0});
  ASSERT_EQ(walk.end, Walk::End::kFound);
  EXPECT_EQ(walk.steps.size(), 21u) << "twenty of 50 mm and one to close the feet";
  EXPECT_EQ(walk.least, 21u);
}

TEST(Walks, LiftTheFootOverATile) {
  const std::vector<Prism> tile{box("tile", 0.13, 0.15, -0.065, -0.035, 0.015)};
  const Walk walk = Course(tile).to({0.4, 0.0, 0.0});
  ASSERT_EQ(walk.end, Walk::End::kFound) << walk.hindrance;
  bool higher = false;
  for (const WalkStep& step : walk.steps) {
    higher = higher || step.stride.lift > 0.015;
    EXPECT_EQ(stands_on(shipped_model(), step.support * step.stride.to, tile, 0.002), nullptr);
  }
  EXPECT_TRUE(higher);
}

TEST(Walks, DoNotLeaveAPenWhoseWallsAreTooHigh) {
  Course course({box("wall", 0.16, 0.17, -0.2, 0.2, 0.03), box("left", -0.2, 0.17, 0.19, 0.2, 0.03),
                 box("right", -0.2, 0.17, -0.2, -0.19, 0.03), box("back", -0.21, -0.2, -0.2, 0.2, 0.03)});
  const Walk walk = course.to({0.4, 0.0, 0.0});
  EXPECT_NE(walk.end, Walk::End::kFound);
}

TEST(Walks, GoRoundABrick) {
  const std::vector<Prism> brick{box("brick", 0.15, 0.25, -0.05, 0.05, 0.06)};
  const Walk walk = Course(brick).to({0.4, 0.0, 0.0});
  ASSERT_EQ(walk.end, Walk::End::kFound) << walk.hindrance;
  EXPECT_GT(walk.steps.size(), 9u);
  for (const WalkStep& step : walk.steps)
    EXPECT_EQ(stands_on(shipped_model(), step.support * step.stride.to, brick, 0.002), nullptr);
}

TEST(Walks, GoOnWhereRowsOfFootstepsFailForTheirStrides) {
  // The goal beside a brick: many placements have room whose strides meet it.
  const std::vector<Prism> brick{box("brick", 0.15, 0.25, -0.05, 0.05, 0.06)};
  const Walk walk = Course(brick).to({0.3603, 0.0696, 0.0});
  ASSERT_EQ(walk.end, Walk::End::kFound) << walk.hindrance;
  EXPECT_GT(walk.routes, 1);
  EXPECT_EQ(walk.least, walk.steps.size());
  Judge judge(shipped_model(), {}, brick);
  for (const WalkStep& step : walk.steps)
    for (const Phase& phase : step.stride.phases) {
      Support at = phase.support;
      at.at = to_world(step.support);
      EXPECT_EQ(certify(judge, phase, at), Fault::kNone) << phase.name;
    }
}

TEST(Walks, AreProvedLeastOnlyWhereNoRowIsShorter) {
  // Least by exhaustion of the proof's nodes or by none: what is said to be least is never more than a walk found with other
  // limits.
  const std::vector<Prism> tile{box("tile", 0.13, 0.15, -0.065, -0.035, 0.015)};
  const Walk walk = Course(tile).to({0.3, 0.05, 0.3});
  ASSERT_EQ(walk.end, Walk::End::kFound);
  const Walk free = Course({}).to({0.3, 0.05, 0.3});
  ASSERT_EQ(free.end, Walk::End::kFound);
  EXPECT_LE(walk.least, walk.steps.size());
  EXPECT_GE(walk.steps.size(), free.least) << "obstacles make no walk shorter";
}

// The brick beside the way: within reach of every sole, but in no foot's way.
const std::vector<Prism> kBeside{box("brick", 0.0, 0.1, 0.14, 0.2, 0.06)};

GaitOptions by_paper(std::size_t iterations) {
  GaitOptions out;
  out.paper.emplace();
  out.paper->method.iterations = iterations;
  return out;
}

TEST(Walks, AmongObstaclesByThePaperAreWhollyByThePaper) {
  Course course(kBeside, by_paper(100'000));
  const Walk walk = course.to({0.10, 0.0, 0.0});
  ASSERT_EQ(walk.end, Walk::End::kFound);
  EXPECT_GE(course.gait.paper_figures().found, walk.steps.size()) << "one way of the method for each stride";
  for (const WalkStep& step : walk.steps) {
    EXPECT_EQ(step.stride.phases.size(), 5u) << "shift, lift, one carry, lower, settle";
    EXPECT_LT(geometry::distance(kBeside[0].polygon, {step.support.x, step.support.y}), 0.3) << "near the brick";
  }
}

TEST(Walks, AmongObstaclesByThePaperAreNoneWhereTheMethodFindsNone) {
  ASSERT_EQ(Course(kBeside).to({0.10, 0.0, 0.0}).end, Walk::End::kFound) << "there is a walk";
  Course course(kBeside, by_paper(1));
  const Walk walk = course.to({0.10, 0.0, 0.0});
  EXPECT_EQ(walk.end, Walk::End::kNoStrides);
  EXPECT_TRUE(walk.steps.empty());
  EXPECT_EQ(course.gait.paper_figures().found, 0u);
}

TEST(Walks, KeepTheBodyOffWhatIsTall) {
  // Between two pillars the feet would have room, the arms have not.
  const std::vector<Prism> pillars{box("left pillar", 0.18, 0.24, 0.10, 0.16, 0.5),
                                   box("right pillar", 0.18, 0.24, -0.16, -0.10, 0.5)};
  Course course(pillars);
  EXPECT_NE(course.walker.refusal(Side::kRight, sole_at(Side::kRight, {0.21, 0.0, 0.0}, course.walker.half_spacing())), "");
}

}  // namespace
}  // namespace foothold::bioloid::testing
