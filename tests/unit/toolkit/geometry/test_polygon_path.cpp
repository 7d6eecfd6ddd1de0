// Shortest ways inside polygons: by hand, against exact arithmetic on random polygons, and the grid's beside them.
#include <gtest/gtest.h>

#include <random>

#include "geometry/grid_path.hpp"
#include "geometry/polygon_path.hpp"
#include "visibility_oracle.hpp"

namespace foothold::geometry {
namespace {

const Polygon kSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Polygon kAngle{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};  // an L, one reflex vertex at (1, 1)

TEST(PolygonPaths, IsStraightInAConvexPolygonAlsoAlongItsBoundary) {
  const PolygonPaths paths(kSquare);
  EXPECT_DOUBLE_EQ(paths.length({0.2, 0.1}, {0.9, 0.8}), std::hypot(0.7, 0.7));
  EXPECT_DOUBLE_EQ(paths.length({0, 0}, {1, 0}), 1.0);
  EXPECT_DOUBLE_EQ(paths.length({0.25, 0}, {0.75, 0}), 0.5);
  EXPECT_DOUBLE_EQ(paths.length({0, 0}, {1, 1}), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(paths.length({0.5, 0}, {0.5, 0}), 0.0);
  EXPECT_EQ(paths.path({0.5, 0.5}, {0.5, 0.5}).size(), 2U);
}

TEST(PolygonPaths, BendsAtAReflexVertexOnly) {
  const PolygonPaths paths(kAngle);
  ASSERT_EQ(paths.reflex_vertices(), 1U);
  EXPECT_DOUBLE_EQ(paths.length({2, 0.5}, {0.5, 2}), std::hypot(1, 0.5) + std::hypot(0.5, 1));
  const std::vector<Vector2d> way = paths.path({2, 0.5}, {0.5, 2});
  ASSERT_EQ(way.size(), 3U);
  EXPECT_EQ(way[1], Vector2d(1, 1));
  EXPECT_EQ(paths.path({2, 0}, {0, 2}).size(), 2U) << "the diagonal touches the vertex and need not bend";
}

TEST(PolygonPaths, RunsAlongEdgesThatMeetInAReflexVertex) {
  const PolygonPaths paths(kAngle);
  EXPECT_DOUBLE_EQ(paths.length({2, 1}, {1, 2}), 2.0);
  EXPECT_DOUBLE_EQ(paths.length({1.5, 1}, {1, 1}), 0.5);
  EXPECT_DOUBLE_EQ(paths.length({1, 1}, {0, 0}), std::sqrt(2.0));
  EXPECT_EQ(paths.path({1, 1}, {1, 2}).size(), 2U);
  EXPECT_DOUBLE_EQ(paths.length({1.5, 1}, {1, 1.5}), 1.0) << "not through the notch, though both ends are on the boundary";
}

TEST(PolygonPaths, HasNoWayFromOutside) {
  const PolygonPaths paths(kAngle);
  EXPECT_TRUE(std::isinf(paths.length({1.5, 1.5}, {0.5, 0.5})));
  EXPECT_TRUE(std::isinf(paths.length({0.5, 0.5}, {1.5, 1.5})));
  EXPECT_TRUE(std::isinf(paths.length({1.6, 1.6}, {1.5, 1.5})));
  EXPECT_TRUE(paths.path({0.5, 0.5}, {3, 3}).empty());
  EXPECT_EQ(paths.nearest({1.5, 1.2}), Vector2d(1.5, 1));
  EXPECT_EQ(paths.nearest({0.5, 0.5}), Vector2d(0.5, 0.5));
}

TEST(PolygonPaths, TakesAnEndThatRoundingPutsJustOutside) {
  const PolygonPaths paths(kAngle);
  EXPECT_NEAR(paths.length({0.5, -1e-10}, {1.5, 1 + 1e-10}), std::hypot(1.0, 1.0), 1e-9);
  EXPECT_TRUE(std::isinf(paths.length({0.5, -1e-6}, {1.5, 0.5})));
}

TEST(PolygonPaths, GoesRoundAHole) {
  const PolygonPaths paths({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
  EXPECT_DOUBLE_EQ(paths.length({0.5, 2}, {3.5, 2.5}), std::hypot(0.5, 1.0) + 2.0 + std::hypot(0.5, 0.5));
  EXPECT_DOUBLE_EQ(paths.length({1, 1}, {3, 3}), 4.0);
  EXPECT_TRUE(std::isinf(paths.length({2, 2}, {0.5, 0.5})));
  EXPECT_FALSE(paths.holds({2, 2}));
  EXPECT_TRUE(paths.holds({1, 2}));
}

// Ends: places inside at random, vertices, middles of edges.
Vector2d random_end(const Polygon& outline, const std::vector<Polygon>& holes, std::mt19937& random) {
  const Polygon& ring = holes.empty() || random() % 2 ? outline : holes[random() % holes.size()];
  const std::size_t k = random() % ring.size();
  switch (random() % 4) {
    case 0:
      return ring[k];
    case 1:
      return 0.5 * (ring[k] + ring[(k + 1) % ring.size()]);
    default:
      break;
  }
  while (true) {
    const Vector2d point{static_cast<double>(random() % 1024) / 1024.0, static_cast<double>(random() % 1024) / 1024.0};
    if (test::exactly_inside(outline, holes, point)) return point;
  }
}

void expect_as_exact(const Polygon& outline, const std::vector<Polygon>& holes, std::uint32_t seed) {
  std::mt19937 random(seed);
  const PolygonPaths paths(outline, holes);
  const Vector2d from = random_end(outline, holes, random), to = random_end(outline, holes, random);
  const double exact = test::exact_length(outline, holes, from, to), ours = paths.length(from, to);
  ASSERT_TRUE(std::isfinite(exact)) << seed;
  ASSERT_NEAR(ours, exact, 1e-9 * std::max(exact, 1e-3)) << "polygon " << seed;
  const std::vector<Vector2d> way = paths.path(from, to);
  ASSERT_GE(way.size(), 2U);
  EXPECT_EQ(way.front(), from);
  EXPECT_EQ(way.back(), to);
  ASSERT_NEAR(length_of(way), ours, 1e-9) << "polygon " << seed;
  for (std::size_t k = 1; k < way.size(); ++k) ASSERT_TRUE(paths.sees(way[k - 1], way[k])) << "polygon " << seed;
}

TEST(PolygonPaths, IsAsLongAsTheExactWayInRandomPolygons) {
  for (std::uint32_t seed = 0; seed < 10'000; ++seed) {
    expect_as_exact(test::random_polygon(seed, 4 + seed % 20), {}, seed);
    if (HasFatalFailure()) return;
  }
}

TEST(PolygonPaths, IsAsLongAsTheExactWayAmongRandomHoles) {
  for (std::uint32_t seed = 0; seed < 1'000; ++seed) {
    std::vector<Polygon> holes;
    for (std::uint32_t k = 0; k < 4; ++k) {
      Polygon hole = test::random_polygon(seed * 4 + k, 3 + (seed + k) % 5);
      std::reverse(hole.begin(), hole.end());
      // One in each quarter of the square.
      for (Vector2d& vertex : hole) vertex = 0.25 * vertex + Vector2d(0.125 + 0.5 * (k % 2), 0.125 + 0.5 * (k / 2));
      holes.push_back(std::move(hole));
    }
    expect_as_exact(kSquare, holes, seed);
    if (HasFatalFailure()) return;
  }
}

TEST(GridPath, IsNeverShorterThanTheShortestWayAndLongerByTheGridsAngles) {
  const PolygonPaths paths(kAngle);
  const Vector2d from{1.95, 0.55}, to{0.55, 1.95};
  const double exact = paths.length(from, to);
  const double eight = length_of(grid_path(paths, from, to, 0.1));
  const double four = length_of(grid_path(paths, from, to, 0.1, GridNeighbours::kFour));
  EXPECT_NEAR(four, 2.8, 0.06) << "the last link may be a diagonal";
  EXPECT_GE(eight, exact - 1e-12);
  EXPECT_GE(four, eight);
  EXPECT_LE(eight, exact * std::sqrt(4.0 - 2.0 * std::sqrt(2.0)) + 0.2)
      << "eight neighbours cost 8 % at most, and the grid's width";
}

TEST(GridPath, EndsWhereItIsAskedToAndStaysInside) {
  const PolygonPaths paths(kAngle);
  const std::vector<Vector2d> way = grid_path(paths, {1.93, 0.51}, {0.57, 1.98}, 0.1);
  ASSERT_GE(way.size(), 3U);
  EXPECT_EQ(way.front(), Vector2d(1.93, 0.51));
  EXPECT_EQ(way.back(), Vector2d(0.57, 1.98));
  for (std::size_t k = 1; k < way.size(); ++k) EXPECT_TRUE(paths.sees(way[k - 1], way[k]));
  EXPECT_TRUE(grid_path(paths, {1.5, 1.5}, {0.5, 0.5}, 0.1).empty());
}

}  // namespace
}  // namespace foothold::geometry
