// What the scene hides, against closed forms.
#include "visibility.hpp"

#include <gtest/gtest.h>

namespace foothold::drawing {
namespace {

SeenFace square(double low, double high, double depth) {
  return {{{low, low, depth}, {high, low, depth}, {high, high, depth}, {low, high, depth}}, {true, true, true, true}, 0, 0};
}

double area_of(const Region& region) {
  double area = 0.0;  // holes go the other way round
  for (const Points& ring : region) area += flat_turn(ring) * flat_area(ring);
  return std::abs(area);
}

TEST(Visibility, PointBehindAFaceIsHiddenAndOneBeforeItIsNot) {
  const Occluders scene({square(0, 10, 5.0)});
  EXPECT_TRUE(scene.hides({5, 5, 0}));
  EXPECT_FALSE(scene.hides({5, 5, 9}));
  EXPECT_FALSE(scene.hides({15, 5, 0}));
  EXPECT_FALSE(scene.hides({5, 5, 5})) << "a point on the face";
}

TEST(Visibility, PointBesideASlantedEdgeIsNotHidden) {
  const Occluders scene({{{{0, 0, 5}, {10, 0, 5}, {0, 10, 5}}, {true, true, true}, 0, 0}});
  EXPECT_TRUE(scene.hides({4, 4, 0}));
  EXPECT_FALSE(scene.hides({8, 8, 0})) << "inside the triangle's bounding box only";
}

TEST(Visibility, SegmentIsHiddenWhereAFaceIsBeforeIt) {
  const Occluders scene({square(2, 4, 5.0)});
  const auto hidden = scene.hidden({0, 3, 0}, {10, 3, 0});
  ASSERT_EQ(hidden.size(), 1u);
  EXPECT_NEAR(hidden[0].first, 0.2, 1e-12);
  EXPECT_NEAR(hidden[0].second, 0.4, 1e-12);
}

TEST(Visibility, SegmentThroughAFaceIsHiddenFromThereOn) {
  const Occluders scene({square(0, 100, 0.0)});
  const auto hidden = scene.hidden({10, 50, 40}, {90, 50, -40});
  ASSERT_EQ(hidden.size(), 1u);
  EXPECT_NEAR(hidden[0].first, 0.5, 1e-3);
  EXPECT_NEAR(hidden[0].second, 1.0, 1e-12);
}

TEST(Visibility, StretchesBehindNeighbouringFacesAreOne) {
  const Occluders scene({square(2, 4, 5.0), {{{4, 2, 5}, {6, 2, 5}, {6, 4, 5}, {4, 4, 5}}, {true, true, true, true}, 0, 0}});
  const auto hidden = scene.hidden({0, 3, 0}, {10, 3, 0});
  ASSERT_EQ(hidden.size(), 1u);
  EXPECT_NEAR(hidden[0].second, 0.6, 1e-12);
}

TEST(Visibility, SegmentTowardsTheViewerIsAPoint) {
  const Occluders scene({square(0, 10, 5.0)});
  EXPECT_EQ(scene.hidden({5, 5, 0}, {5, 5, 1}).size(), 1u);
  EXPECT_TRUE(scene.hidden({5, 5, 7}, {5, 5, 8}).empty());
}

TEST(Visibility, PolygonHalfBehindAFaceIsSplitThere) {
  const Occluders scene({square(0, 10, 5.0)});
  const SplitRegion parts = scene.split({{5, 2, 0}, {15, 2, 0}, {15, 6, 0}, {5, 6, 0}});
  EXPECT_FALSE(parts.untouched);
  EXPECT_NEAR(area_of(parts.hidden), 20.0, 0.1);
  EXPECT_NEAR(area_of(parts.visible), 20.0, 0.1);
}

TEST(Visibility, PolygonBeforeEverythingIsUntouched) {
  const Occluders scene({square(0, 10, 5.0)});
  const SplitRegion parts = scene.split({{5, 2, 6}, {15, 2, 6}, {15, 6, 6}, {5, 6, 6}});
  EXPECT_TRUE(parts.untouched);
  EXPECT_TRUE(parts.hidden.empty());
  EXPECT_NEAR(area_of(parts.visible), 40.0, 1e-9);
}

TEST(Visibility, WhatLiesOnAFaceIsNotHiddenByIt) {
  const Occluders scene({square(0, 10, 5.0)});
  EXPECT_TRUE(scene.split({{2, 2, 5}, {8, 2, 5}, {8, 8, 5}}).untouched);
}

TEST(Visibility, PolygonStuckThroughAFaceIsHiddenBeyondTheMeetingLine) {
  const Occluders scene({square(0, 100, 0.0)});
  const SplitRegion parts = scene.split({{20, 40, -30}, {80, 40, 30}, {80, 60, 30}, {20, 60, -30}});
  EXPECT_NEAR(area_of(parts.hidden), 600.0, 2.0);
  EXPECT_NEAR(area_of(parts.visible), 600.0, 2.0);
}

TEST(Visibility, FaceInTheMiddleLeavesAHole) {
  const Occluders scene({square(4, 6, 5.0)});
  const SplitRegion parts = scene.split({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}});
  EXPECT_EQ(parts.visible.size(), 2u);
  EXPECT_NEAR(area_of(parts.visible), 96.0, 0.1);
}

TEST(Visibility, NoSceneHidesNothing) {
  const Occluders nothing({});
  EXPECT_FALSE(nothing.hides({0, 0, 0}));
  EXPECT_TRUE(nothing.hidden({0, 0, 0}, {1, 1, 1}).empty());
  EXPECT_TRUE(nothing.split({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).untouched);
}

}  // namespace
}  // namespace foothold::drawing
