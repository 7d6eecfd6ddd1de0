// Distances between polygons, against sampling; crossings.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "geometry/polygon.hpp"

namespace foothold::geometry {
namespace {

const Polygon kSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Polygon kHook{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {0, 1}};

TEST(Polygon, KnowsItsArea) {
  EXPECT_DOUBLE_EQ(signed_area(kSquare), 1.0);
  EXPECT_DOUBLE_EQ(signed_area(Polygon{{0, 0}, {0, 1}, {1, 1}, {1, 0}}), -1.0);
  EXPECT_DOUBLE_EQ(signed_area(kHook), 5.0);
}

TEST(Polygon, ContainsWhatIsInsideEvenInAHook) {
  EXPECT_TRUE(contains(kHook, {2.5, 2.5}));
  EXPECT_TRUE(contains(kHook, {0.5, 0.5}));
  EXPECT_FALSE(contains(kHook, {1.0, 2.0}));
  EXPECT_FALSE(contains(kHook, {-0.1, 0.5}));
}

TEST(Polygon, DistancesOfCrossingNestedAndSeparatePolygons) {
  const Polygon inside{{0.4, 0.4}, {0.6, 0.4}, {0.5, 0.6}};
  EXPECT_EQ(distance(kSquare, inside), 0.0);
  EXPECT_EQ(distance(inside, kSquare), 0.0);
  // A cross: no vertex of one lies in the other.
  const Polygon bar{{-1, 0.4}, {2, 0.4}, {2, 0.6}, {-1, 0.6}};
  const Polygon post{{0.4, -1}, {0.6, -1}, {0.6, 2}, {0.4, 2}};
  EXPECT_EQ(distance(bar, post), 0.0);
  EXPECT_DOUBLE_EQ(distance(kSquare, Polygon{{4, 5}, {6, 5}, {6, 7}}), 5.0);
  EXPECT_DOUBLE_EQ(distance(kHook, Vector2d(1, 2), Vector2d(0.5, 4)), 1.0);
  EXPECT_EQ(distance(kHook, Vector2d(-1, 0.5), Vector2d(4, 0.5)), 0.0);
  EXPECT_EQ(distance(kHook, Vector2d(2.2, 2.0), Vector2d(2.4, 2.1)), 0.0);
  EXPECT_DOUBLE_EQ(distance(kHook, Vector2d(1, 1.25)), 0.25);
}

TEST(Polygon, DistanceIsThatOfTheNearestPairOfBoundaryPoints) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto blob = [&](double x, double y) {
    Polygon out;
    for (int k = 0; k < 7; ++k) {
      const double angle = 2 * std::numbers::pi * k / 7;
      const double r = 0.2 + 0.8 * unit(random);
      out.emplace_back(x + r * std::cos(angle), y + r * std::sin(angle));
    }
    return out;
  };
  const auto samples = [](const Polygon& p) {
    std::vector<Vector2d> out;
    for (std::size_t k = 0; k < p.size(); ++k)
      for (int s = 0; s < 200; ++s) out.push_back(p[k] + (p[(k + 1) % p.size()] - p[k]) * s / 200.0);
    return out;
  };
  for (int round = 0; round < 40; ++round) {
    const Polygon a = blob(0, 0);
    const Polygon b = blob(3.0 * unit(random), 3.0 * unit(random));
    double least = 1e9;
    bool overlap = false;
    for (const Vector2d& p : samples(a)) {
      overlap |= contains(b, p);
      for (const Vector2d& q : samples(b)) least = std::min(least, (p - q).norm());
    }
    for (const Vector2d& q : samples(b)) overlap |= contains(a, q);
    if (overlap)
      EXPECT_EQ(distance(a, b), 0.0);
    else
      EXPECT_NEAR(distance(a, b), least, 0.01);
  }
}

TEST(Polygon, FindsCrossingsAndFolds) {
  EXPECT_FALSE(first_crossing(kSquare));
  EXPECT_FALSE(first_crossing(kHook));
  EXPECT_TRUE(first_crossing(Polygon{{0, 0}, {1, 1}, {1, 0}, {0, 1}}));          // a bow tie
  EXPECT_TRUE(first_crossing(Polygon{{0, 0}, {2, 0}, {1, 0}, {1, 1}}));          // folds back
  EXPECT_TRUE(first_crossing(Polygon{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));  // touches itself
}

TEST(Polygon, CircleRoundHoldsAllVertices) {
  const Circle circle = circle_round(kHook);
  for (const Vector2d& v : kHook) EXPECT_LE((v - circle.centre).norm(), circle.radius);
}

}  // namespace
}  // namespace foothold::geometry
