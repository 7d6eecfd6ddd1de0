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
  explicit Course(std::vector<Prism> obstacles)
      : prisms(std::move(obstacles)), gait(shipped_model(), {}), walker(shipped_model(), gait, {}, prisms) {}
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

TEST(Walks, KeepTheBodyOffWhatIsTall) {
  // Between two pillars the feet would have room, the arms have not.
  const std::vector<Prism> pillars{box("left pillar", 0.18, 0.24, 0.10, 0.16, 0.5),
                                   box("right pillar", 0.18, 0.24, -0.16, -0.10, 0.5)};
  Course course(pillars);
  EXPECT_NE(course.walker.refusal(Side::kRight, sole_at(Side::kRight, {0.21, 0.0, 0.0}, course.walker.half_spacing())), "");
}

}  // namespace
}  // namespace foothold::bioloid::testing
