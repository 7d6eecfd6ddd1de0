// Shortest ways of a point round obstacles, against a grid and by hand.
#include <gtest/gtest.h>

#include <queue>
#include <random>

#include "geometry/geodesic.hpp"

namespace foothold::geometry {
namespace {

const Polygon kWall{{-1, 1}, {1, 1}, {1, 1.2}, {-1, 1.2}};

TEST(Geodesic, IsStraightWhereNothingIsInTheWay) {
  const Geodesic field({0, 0}, {kWall});
  EXPECT_DOUBLE_EQ(field.distance({3, 0.5}), std::hypot(3, 0.5));
  EXPECT_DOUBLE_EQ(field.distance({0, 0}), 0.0);
  EXPECT_DOUBLE_EQ(field.distance({1, 1}), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(Geodesic({1, 2}, {}).distance({4, 6}), 5.0);
}

TEST(Geodesic, GoesRoundTheNearerEndOfAWall) {
  const Geodesic field({0, 0}, {kWall});
  EXPECT_DOUBLE_EQ(field.distance({0.1, 2.2}), std::sqrt(2.0) + 0.2 + std::hypot(0.9, 1.0));
  EXPECT_DOUBLE_EQ(field.distance({-0.1, 2.2}), std::sqrt(2.0) + 0.2 + std::hypot(0.9, 1.0));
}

TEST(Geodesic, PassesBetweenObstaclesThatTouchOnlyAlongTheirEdges) {
  // Two boxes side by side: a point can slip between them along the common edge, nothing with a width can.
  const Geodesic field({0.5, -1}, {{{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}, {{0.5, 0}, {1, 0}, {1, 1}, {0.5, 1}}});
  EXPECT_DOUBLE_EQ(field.distance({0.5, 2}), 3.0);
}

TEST(Geodesic, IsInfiniteInsideAClosedYard) {
  const Geodesic field({0, 0}, {{{-2, -2}, {2, -2}, {2, -1.9}, {-2, -1.9}},
                                {{-2, 1.9}, {2, 1.9}, {2, 2}, {-2, 2}},
                                {{-2, -2}, {-1.9, -2}, {-1.9, 2}, {-2, 2}},
                                {{1.9, -2}, {2, -2}, {2, 2}, {1.9, 2}}});
  EXPECT_TRUE(std::isinf(field.distance({5, 0})));
  EXPECT_TRUE(std::isfinite(field.distance({1.8, 1.8})));
}

TEST(Geodesic, AgreesWithADenseGrid) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int round = 0; round < 5; ++round) {
    std::vector<Polygon> obstacles;
    for (int k = 0; k < 6; ++k) {
      const Vector2d at(0.2 + 0.6 * unit(random), 0.2 + 0.6 * unit(random));
      Polygon p;
      for (int i = 0; i < 5; ++i) {
        const double r = 0.05 + 0.1 * unit(random);
        p.emplace_back(at.x() + r * std::cos(1.2566 * i), at.y() + r * std::sin(1.2566 * i));
      }
      obstacles.push_back(p);
    }
    const Vector2d goal(0.01, 0.01);
    const Geodesic field(goal, obstacles);
    constexpr int kCells = 100;
    std::vector<double> grid(kCells * kCells, 1e9);
    const auto centre = [&](int k) { return Vector2d((k % kCells + 0.5) / kCells, (k / kCells + 0.5) / kCells); };
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    grid[kCells + 1] = (centre(kCells + 1) - goal).norm();
    open.emplace(grid[kCells + 1], kCells + 1);
    const auto free = [&](int k) {
      return std::none_of(obstacles.begin(), obstacles.end(), [&](const Polygon& p) { return contains(p, centre(k)); });
    };
    while (!open.empty()) {
      const auto [length, k] = open.top();
      open.pop();
      if (length > grid[static_cast<std::size_t>(k)]) continue;
      for (int dr = -1; dr <= 1; ++dr)
        for (int dc = -1; dc <= 1; ++dc) {
          const int r = k / kCells + dr, c = k % kCells + dc;
          if (r < 0 || c < 0 || r >= kCells || c >= kCells || !free(r * kCells + c)) continue;
          double& there = grid[static_cast<std::size_t>(r * kCells + c)];
          if (length + std::hypot(dr, dc) / kCells < there)
            there = length + std::hypot(dr, dc) / kCells, open.emplace(there, r * kCells + c);
        }
    }
    for (int sample = 0; sample < 100; ++sample) {
      const int k = static_cast<int>(random() % (kCells * kCells));
      if (!free(k) || grid[static_cast<std::size_t>(k)] > 1e8) continue;
      const double exact = field.distance(centre(k));
      EXPECT_LE(exact, grid[static_cast<std::size_t>(k)] + 0.03);
      EXPECT_GE(exact, (grid[static_cast<std::size_t>(k)] - 0.05) / 1.0824);
    }
  }
}

}  // namespace
}  // namespace foothold::geometry
