// Where the robot's bodies cut the scene, and where they merely touch it or stand on it.
#include "crossings.hpp"

#include <gtest/gtest.h>

#include "samples.hpp"

namespace foothold::drawing {
namespace {

using namespace samples;

// One stance of these bodies in this scene.
std::vector<Crossing> crossings_of(const std::vector<msg::Shape>& robot, const std::vector<msg::Shape>& scene,
                                   const std::vector<msg::Contact>& stance = {}) {
  Drawing drawing;
  drawing.scene = scene;
  msg::Step one = step(0, pose(0, 0, 0));
  one.shapes(robot);
  one.stance(stance);
  drawing.steps = {one};
  return crossings(checked_plan(drawing, {}));
}

const msg::Shape kBeam = box("beam", 0, 0, 0, 2.0, 0.15, 0.15);

TEST(Crossings, CapsuleThroughABeamCutsItsTwoFaces) {
  const auto found = crossings_of({capsule("leg", {0.3, 0, -0.5}, {0.3, 0, 0.5}, 0.03)}, {kBeam});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].body, "leg");
  EXPECT_EQ(found[0].piece, "beam");
  for (const Crossing& one : found) {
    EXPECT_NEAR(std::abs(one.region[0].z()), 0.075, 1e-9);
    EXPECT_NEAR(newell(one.region).norm() / 2.0, M_PI * 0.03 * 0.03, 0.15 * M_PI * 0.03 * 0.03);
  }
}

TEST(Crossings, BodiesBesideABeamDoNotCutIt) {
  EXPECT_TRUE(crossings_of({capsule("leg", {0, 0.076 + 0.03, -0.5}, {0, 0.076 + 0.03, 0.5}, 0.03)}, {kBeam}).empty());
  EXPECT_TRUE(crossings_of({sphere("knee", 0, 0, 0.075 + 0.0401, 0.04)}, {kBeam}).empty());
  EXPECT_TRUE(crossings_of({box("hip", 0, 0.2, 0, 0.1, 0.1, 0.1)}, {kBeam}).empty());
}

TEST(Crossings, PlateThatRestsOnAFaceDoesNotCutIt) {
  EXPECT_TRUE(crossings_of({box("plate", 0, 0, 0.075 + 0.005, 0.1, 0.1, 0.01)}, {kBeam}).empty());
  EXPECT_TRUE(crossings_of({box("sheet", 0, 0, 0.075, 0.1, 0.1, 0.0)}, {kBeam}).empty());
}

TEST(Crossings, PlateSunkIntoAFaceCutsIt) {
  EXPECT_FALSE(crossings_of({box("plate", 0, 0, 0.075 + 0.004, 0.1, 0.1, 0.01)}, {kBeam}).empty());
}

TEST(Crossings, BodyWhollyInsideABeamIsFound) {
  EXPECT_FALSE(crossings_of({box("lost", 0, 0, 0, 0.02, 0.02, 0.02)}, {kBeam}).empty());
  EXPECT_FALSE(crossings_of({sphere("lost", 0, 0, 0, 0.02)}, {kBeam}).empty());
  EXPECT_FALSE(crossings_of({capsule("lost", {0, 0, 0}, {0.2, 0, 0}, 0.02)}, {kBeam}).empty());
  EXPECT_FALSE(crossings_of({polygon("lost", {{0, 0, 0}, {0.1, 0, 0}, {0, 0.05, 0}})}, {kBeam}).empty());
}

TEST(Crossings, FootTipRoundItsOwnContactIsLeftOut) {
  const std::vector<msg::Shape> ground{polygon("ground", {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}}),
                                       polygon("ground", {{-1, -1, 0}, {1, 1, 0}, {-1, 1, 0}})};
  // On the very edge of the two triangles, so that the tip sinks into both.
  const auto tibia = capsule("tibia", {0, 0, 0}, {0.1, 0, 0.2}, 0.01);
  EXPECT_TRUE(crossings_of({tibia}, ground, {contact("L1", pose(0, 0, 0))}).empty());
  EXPECT_FALSE(crossings_of({tibia}, ground, {contact("L1", pose(0.5, 0, 0))}).empty()) << "a contact elsewhere is none here";
}

// A body that stands in the plane has its contact under its middle: a wall that it is pushed into is none of its foothold.
TEST(Crossings, WallBesideABodysOwnContactIsFound) {
  const auto wall = polygon("wall", {{0.04, -1, 0}, {0.04, 1, 0}, {0.04, 1, 0.1}, {0.04, -1, 0.1}});
  const auto body = box("A", 0, 0, 0.02, 0.1, 0.1, 0.04);
  EXPECT_EQ(crossings_of({body}, {wall}, {contact("A", pose(0, 0, 0))}).size(), 1u);
}

TEST(Crossings, LegFromItsContactThroughTheBeamIsFoundOnTheFarSide) {
  const auto found = crossings_of({capsule("leg", {0, 0, 0.075}, {0, 0, -0.4}, 0.03)}, {kBeam}, {contact("A", pose(0, 0, 0.075))});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].region[0].z(), -0.075, 1e-9);
}

TEST(Crossings, RoundPiecesOfTheSceneAreCutToo) {
  EXPECT_FALSE(crossings_of({capsule("leg", {0, 0, -0.5}, {0, 0, 0.5}, 0.03)}, {capsule("pipe", {-1, 0.05, 0}, {1, 0.05, 0}, 0.04)})
                   .empty());
  EXPECT_TRUE(crossings_of({capsule("leg", {0, 0, -0.5}, {0, 0, 0.5}, 0.03)}, {capsule("pipe", {-1, 0.08, 0}, {1, 0.08, 0}, 0.04)})
                  .empty());
}

TEST(Crossings, OutlinesInOnePlaneCutWhereTheyOverlapAndNotWhereTheyTouch) {
  const auto obstacle = polygon("crate", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  const auto found = crossings_of({polygon("A", {{0.9, 0.2, 0}, {1.5, 0.2, 0}, {1.5, 0.4, 0}, {0.9, 0.4, 0}})}, {obstacle});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(newell(found[0].region).norm() / 2.0, 0.1 * 0.2, 1e-5);
  EXPECT_TRUE(crossings_of({polygon("A", {{1.0, 0.2, 0}, {1.5, 0.2, 0}, {1.5, 0.4, 0}, {1.0, 0.4, 0}})}, {obstacle}).empty());
}

TEST(Crossings, FloorThatAContactNamesIsNoObstacle) {
  const auto floor = polygon("floor", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  const auto body = polygon("A", {{0.2, 0.2, 0}, {0.5, 0.2, 0}, {0.5, 0.4, 0}});
  EXPECT_TRUE(crossings_of({body}, {floor}, {contact("A", pose(0.3, 0.3, 0), "floor")}).empty());
  EXPECT_FALSE(crossings_of({body}, {floor}, {contact("A", pose(0.3, 0.3, 0))}).empty());
}

TEST(Crossings, PlateThroughAnUprightFaceCutsItInASegment) {
  const auto wall = polygon("wall", {{0, -1, 0}, {0, 1, 0}, {0, 1, 1}, {0, -1, 1}});
  const auto found =
      crossings_of({polygon("plate", {{-0.2, -0.1, 0.5}, {0.2, -0.1, 0.5}, {0.2, 0.1, 0.5}, {-0.2, 0.1, 0.5}})}, {wall});
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(found[0].region.size(), 2u);
  EXPECT_NEAR((found[0].region[0] - found[0].region[1]).norm(), 0.2, 1e-5);
}

TEST(Crossings, PlateThatTouchesAnUprightFaceWithItsEdgeDoesNotCutIt) {
  const auto wall = polygon("wall", {{0, -1, 0}, {0, 1, 0}, {0, 1, 1}, {0, -1, 1}});
  EXPECT_TRUE(crossings_of({polygon("plate", {{0, -0.1, 0.5}, {0.2, -0.1, 0.5}, {0.2, 0.1, 0.5}, {0, 0.1, 0.5}})}, {wall}).empty());
  EXPECT_TRUE(
      crossings_of({polygon("plate", {{0, -0.1, 0.5}, {-0.2, -0.1, 0.5}, {-0.2, 0.1, 0.5}, {0, 0.1, 0.5}})}, {wall}).empty());
  EXPECT_TRUE(crossings_of({polygon("plate", {{0, 0, 0.5}, {-0.2, -0.1, 0.5}, {-0.2, 0.1, 0.5}})}, {wall}).empty());
}

// A thick body's contact is on it, but what it cuts far from there is no foothold, though it lies in the contact's plane.
TEST(Crossings, WhatIsFarFromTheContactInItsPlaneIsFound) {
  const auto floor = polygon("floor", {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  const auto shin = capsule("shin", {0, 0, 0}, {0.5, 0, 0}, 0.02);
  EXPECT_FALSE(crossings_of({shin}, {floor}, {contact("A", pose(0, 0, 0))}).empty());
}

TEST(Crossings, SamplesAreFreeOfThemButForTheOneMadeToCross) {
  EXPECT_TRUE(crossings(checked_plan(biped(false), {})).empty());
  EXPECT_TRUE(crossings(checked_plan(hexapod(), {})).empty());
  const auto through = crossings(checked_plan(biped(true), {}));
  ASSERT_FALSE(through.empty());
  for (const Crossing& one : through) EXPECT_EQ(one.step, biped(true).steps.back().index());
}

}  // namespace
}  // namespace foothold::drawing
