// Clipping and convex pieces.
#include "polygon.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace foothold::drawing {
namespace {

Points square(double low, double high, double z = 0.0) { return {{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}}; }

TEST(Polygon, OverlapOfTwoSquaresIsTheirCommonSquareAtTheFirstOnesDepth) {
  const Points common = overlap(square(0, 2, 5.0), square(1, 3, 7.0));
  EXPECT_DOUBLE_EQ(flat_area(common), 1.0);
  for (const Vector3d& p : common) EXPECT_DOUBLE_EQ(p.z(), 5.0);
}

TEST(Polygon, OverlapDoesNotDependOnWhichWayRoundTheVerticesGo) {
  Points turned = square(1, 3);
  std::reverse(turned.begin(), turned.end());
  EXPECT_DOUBLE_EQ(flat_area(overlap(square(0, 2), turned)), 1.0);
}

TEST(Polygon, SquaresThatShareAnEdgeDoNotOverlap) {
  const Points neighbour{{2, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}};
  const Points common = overlap(square(0, 2), neighbour);
  EXPECT_DOUBLE_EQ(common.empty() ? 0.0 : flat_area(common), 0.0);
}

TEST(Polygon, DepthPlaneGivesBackItsPoints) {
  const Points face{{0, 0, 1}, {4, 0, 3}, {4, 4, 7}, {0, 4, 5}};
  const auto plane = depth_plane(face);
  ASSERT_TRUE(plane.has_value());
  for (const Vector3d& p : face) EXPECT_NEAR((*plane)(p), p.z(), 1e-12);
}

TEST(Polygon, EdgeOnFaceHasNoDepthPlane) { EXPECT_FALSE(depth_plane({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}).has_value()); }

TEST(Polygon, ConvexOneIsItsOwnOnlyPiece) {
  const auto pieces = convex_pieces(square(0, 1));
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].points.size(), 4u);
}

// An L turned anywhere in space, given either way round.
TEST(Polygon, PiecesOfAConcaveOneHaveItsAreaAndItsOutline) {
  const Points flat{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  Points turned;
  for (const Vector3d& p : flat) turned.emplace_back(turn * p + Vector3d(5, 6, 7));
  for (int way = 0; way < 2; ++way) {
    const auto pieces = convex_pieces(turned);
    double area = 0.0, border = 0.0;
    for (const ConvexPiece& piece : pieces) {
      area += newell(piece.points).norm() / 2.0;
      for (std::size_t i = 0; i < piece.points.size(); ++i)
        if (piece.outline[i]) border += (piece.points[(i + 1) % piece.points.size()] - piece.points[i]).norm();
    }
    EXPECT_NEAR(area, 5.0, 1e-12);
    EXPECT_NEAR(border, 12.0, 1e-12);
    std::reverse(turned.begin(), turned.end());
  }
}

TEST(Polygon, RandomStarShapedOnesKeepTheirArea) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> radius(0.2, 1.0);
  for (int run = 0; run < 200; ++run) {
    const int corners = 5 + run % 20;
    Points star;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2.0 * M_PI * i / corners, r = radius(random);
      star.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
    }
    double area = 0.0;
    for (const ConvexPiece& piece : convex_pieces(star)) area += newell(piece.points).norm() / 2.0;
    EXPECT_NEAR(area, newell(star).norm() / 2.0, 1e-12) << "run " << run;
  }
}

TEST(Polygon, RepeatedAndCollinearVerticesAreFine) {
  const Points l{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 1, 0}, {1, 2, 0}, {1, 3, 0}, {0, 3, 0}};
  double area = 0.0;
  for (const ConvexPiece& piece : convex_pieces(l)) area += newell(piece.points).norm() / 2.0;
  EXPECT_NEAR(area, 5.0, 1e-12);
}

TEST(Polygon, OneThatCrossesItselfHasNoPieces) {
  EXPECT_TRUE(convex_pieces({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1.5, 0}}).empty());
  // A five-pointed star drawn in one go turns one way only, but twice.
  Points star;
  for (int i = 0; i < 5; ++i) star.emplace_back(std::cos(4.0 * M_PI * i / 5.0), std::sin(4.0 * M_PI * i / 5.0), 0.0);
  EXPECT_TRUE(convex_pieces(star).empty());
}

TEST(Polygon, SegmentIsClippedToASegment) {
  const Points rest = clipped(Points{{-1, 0, 0}, {3, 0, 4}}, [](const Vector3d& p) { return p.x(); });
  ASSERT_EQ(rest.size(), 2u);
  EXPECT_TRUE(rest[0].isApprox(Vector3d(0, 0, 1)));
  EXPECT_TRUE(rest[1].isApprox(Vector3d(3, 0, 4)));
}

}  // namespace
}  // namespace foothold::drawing
