// What is removed from paths, and what is not.
#include <gtest/gtest.h>

#include "bioloid/paper/sections.hpp"
#include "spaces.hpp"

namespace foothold::bioloid::paper::testing {
namespace {

constexpr auto kAll = [](const Point&) { return true; };

TEST(Sections, LoopsAreRemoved) {
  const Space space = grid(point({9, 9}), kAll);
  const auto path = points({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 1}, {3, 2}, {2, 1}, {1, 0}, {0, 1}, {0, 2}});
  EXPECT_EQ(without_useless_sections(space, path), points({{0, 0}, {0, 1}, {0, 2}})) << "(1, 0) leads nowhere";
}

TEST(Sections, MovementsThatLeadNowhereAreRemovedUnlessTheyEvadeSomething) {
  Space space = grid(point({9, 9}), kAll);
  const auto path = points({{0, 0}, {0, 1}, {1, 1}, {2, 1}, {2, 0}, {3, 0}});
  EXPECT_EQ(without_useless_sections(space, path), points({{0, 0}, {1, 1}, {2, 0}, {3, 0}}));
  space.joins = [](const Point& a, const Point& b) { return (a - b).cwiseAbs().sum() <= 1.0; };  // one joint at a time
  EXPECT_EQ(without_useless_sections(space, path), path);
}

// The end effector knows the first coordinate alone.
Space seen_from_aside() {
  Space space = grid(point({9, 9}), kAll);
  space.place = [](const Point& at) { return Point(at.head(1)); };
  return space;
}

TEST(Trimming, WhatLiesBetweenEqualPositionsIsCut) {
  const auto path = points({{0, 0}, {1, 0}, {2, 1}, {1, 4}, {0, 5}, {1, 6}, {2, 7}, {3, 7}});
  EXPECT_EQ(trimmed(seen_from_aside(), path), points({{0, 0}, {0, 5}, {1, 6}, {2, 7}, {3, 7}}));
}

TEST(Trimming, ACutWhoseMovementIsNotValidIsNotMade) {
  Space space = seen_from_aside();
  const auto path = points({{0, 0}, {1, 0}, {2, 1}, {1, 4}, {0, 5}, {1, 6}, {2, 7}, {3, 7}});
  space.joins = [](const Point& a, const Point& b) { return std::abs(a.y() - b.y()) < 4.5; };
  // (0, 0) to (0, 5) is not made, (1, 0) to (1, 6) neither, (1, 0) to (1, 4) is.
  EXPECT_EQ(trimmed(space, path), points({{0, 0}, {1, 0}, {1, 4}, {1, 6}, {2, 7}, {3, 7}}));
}

TEST(Trimming, APositionWithinTheToleranceIsEqual) {
  Space space = seen_from_aside();
  const auto path = points({{0, 0}, {1, 0}, {0.05, 1}, {3, 1}});
  EXPECT_EQ(trimmed(space, path), path);
  space.equal = 0.1;
  EXPECT_EQ(trimmed(space, path), points({{0, 0}, {0.05, 1}, {3, 1}}));
}

TEST(Trimming, LoopsOfThePathItselfAreCutToOnePoint) {
  const Space space = grid(point({9}), kAll);
  EXPECT_EQ(trimmed(space, points({{0}, {1}, {2}, {1}, {0}, {1}, {2}, {3}})), points({{0}, {1}, {2}, {3}}));
}

}  // namespace
}  // namespace foothold::bioloid::paper::testing
