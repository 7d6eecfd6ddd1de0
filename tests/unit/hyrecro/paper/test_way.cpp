// Circles across the continuous way, and the safe polygon; by hand.
#include <gtest/gtest.h>

#include "hyrecro/paper/way.hpp"

namespace foothold::hyrecro {
namespace {

const std::vector<Vector2d> kCorner{{0, 0}, {1, 0}, {1, 1}};

TEST(Crossing, IsWhereTheWayLeavesTheCircle) {
  EXPECT_TRUE(crossing(kCorner, {0, 0}, 0.5).isApprox(Vector2d(0.5, 0), 1e-12));
  EXPECT_TRUE(crossing(kCorner, {0.5, 0}, 0.8).isApprox(Vector2d(1, std::sqrt(0.64 - 0.25)), 1e-12));
}

TEST(Crossing, IsTheLastOfSeveral) {
  const std::vector<Vector2d> hairpin{{0, 0}, {2, 0}, {2, 0.2}, {-1, 0.2}};
  EXPECT_TRUE(crossing(hairpin, {0.5, 0}, 0.5).isApprox(Vector2d(0.5 - std::sqrt(0.25 - 0.04), 0.2), 1e-12));
}

TEST(Crossing, IsTheWaysEndIfThatLiesWithin) { EXPECT_EQ(crossing(kCorner, {1, 0.5}, 0.6), Vector2d(1, 1)); }

TEST(Crossing, IsTheNearestPointIfTheWayNeverIsInside) {
  EXPECT_TRUE(crossing(kCorner, {0.4, -0.5}, 0.3).isApprox(Vector2d(0.4, 0), 1e-12));
  EXPECT_TRUE(crossing(kCorner, {-1, 0}, 0.3).isApprox(Vector2d(0, 0), 1e-12));
}

truss::Face face(const Polygon& outline) {
  truss::Face out;
  out.name = "face";
  out.frame = Isometry3d::Identity();
  out.outline = outline;
  return out;
}

TEST(SafeGround, KeepsItsDistanceAndLeadsRoundCorners) {
  const SafeGround ground(face({{0, 0}, {2, 0}, {2, 0.4}, {0.4, 0.4}, {0.4, 2}, {0, 2}}), 0.07);
  EXPECT_TRUE(ground.holds({0.08, 0.08}));
  EXPECT_FALSE(ground.holds({0.06, 0.2}));
  const std::vector<Vector2d> way = ground.way({1.5, 0.2}, {0.2, 1.5}, FaceWay::kVisibility);
  ASSERT_EQ(way.size(), 3U);
  EXPECT_NEAR((way[1] - Vector2d(0.33, 0.33)).norm(), 0.0, 1e-6) << "the reflex corner, 0.07 m inwards from both its edges";
  const std::vector<Vector2d> grid = ground.way({1.5, 0.2}, {0.2, 1.5}, FaceWay::kGrid);
  ASSERT_GE(grid.size(), 3U);
  EXPECT_GT(geometry::length_of(grid), geometry::length_of(way));
}

TEST(SafeGround, JoinsEndsThatLieOutsideByTheShortestLine) {
  const SafeGround ground(face({{0, 0}, {2, 0}, {2, 0.4}, {0, 0.4}}), 0.07);
  const std::vector<Vector2d> way = ground.way({0.5, 0.05}, {1.5, 0.05}, FaceWay::kVisibility);
  ASSERT_EQ(way.size(), 4U);
  EXPECT_EQ(way.front(), Vector2d(0.5, 0.05));
  EXPECT_NEAR((way[1] - Vector2d(0.5, 0.07)).norm(), 0.0, 1e-6);
  EXPECT_EQ(way.back(), Vector2d(1.5, 0.05));
}

TEST(SafeGround, HasNoWayBetweenPartsOrInAStripTooNarrow) {
  // Two squares joined by a neck 0.1 m wide.
  const SafeGround ground(
      face({{0, 0}, {1, 0}, {1, 0.45}, {2, 0.45}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 0.55}, {1, 0.55}, {1, 1}, {0, 1}}), 0.07);
  EXPECT_FALSE(ground.empty());
  EXPECT_TRUE(ground.way({0.5, 0.5}, {2.5, 0.5}, FaceWay::kVisibility).empty());
  EXPECT_FALSE(ground.way({0.2, 0.5}, {0.5, 0.5}, FaceWay::kVisibility).empty());
  EXPECT_TRUE(SafeGround(face({{0, 0}, {2, 0}, {2, 0.12}, {0, 0.12}}), 0.07).empty());
}

}  // namespace
}  // namespace foothold::hyrecro
