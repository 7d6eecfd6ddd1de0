// Support polygons against an exhaustive definition, NESM against tipping the robot over its edges step by step.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "contact/nesm.hpp"

namespace foothold::contact {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> random_points(std::mt19937_64& random, std::size_t count) {
  std::uniform_real_distribution<double> place(-0.3, 0.3);
  std::vector<Vector3d> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back({place(random), place(random), 0.3 * place(random)});
  return out;
}

// A hull's edges by definition: pairs with all other points on their left.
std::vector<std::pair<Vector3d, Vector3d>> edges_by_definition(const std::vector<Vector3d>& points) {
  std::vector<std::pair<Vector3d, Vector3d>> out;
  for (const Vector3d& a : points)
    for (const Vector3d& b : points) {
      if (&a == &b) continue;
      const bool edge = std::all_of(points.begin(), points.end(), [&](const Vector3d& c) {
        return &c == &a || &c == &b || (b - a).head<2>().x() * (c - a).y() - (b - a).y() * (c - a).x() > 0.0;
      });
      if (edge) out.emplace_back(a, b);
    }
  return out;
}

// How high the centre of mass rises while the robot turns about the edge until it stands right over it, by small steps.
double rise_by_turning(const Vector3d& a, const Vector3d& b, const Vector3d& com) {
  double highest = com.z();
  for (const double sense : {1.0, -1.0}) {
    double top = -std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 50'000; ++i) {
      const Eigen::AngleAxisd turn(sense * i * std::numbers::pi / 50'000, (b - a).normalized());
      top = std::max(top, (a + turn * (com - a)).z());
    }
    highest = std::max(highest, top);
  }
  return highest - com.z();
}

TEST(SupportPolygon, ItsEdgesAreThoseWithAllOthersOnTheirLeft) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2'000; ++i) {
    const std::vector<Vector3d> points = random_points(random, 3 + random() % 8);
    const SupportPolygon polygon = support_polygon(points);
    const auto edges = edges_by_definition(points);
    ASSERT_EQ(polygon.count, edges.size());
    for (std::size_t k = 0; k < polygon.count; ++k) {
      const auto edge = std::make_pair(polygon.corners[k], polygon.corners[(k + 1) % polygon.count]);
      ASSERT_TRUE(std::find(edges.begin(), edges.end(), edge) != edges.end());
    }
  }
}

TEST(SupportPolygon, WithoutAnAreaThereIsALineAPointOrNothing) {
  EXPECT_EQ(support_polygon({}).count, 0U);
  const std::vector<Vector3d> point{{1, 2, 3}}, same(4, {1, 2, 3}), line{{0, 0, 0}, {2, 2, 1}, {1, 1, 5}};
  EXPECT_EQ(support_polygon(point).count, 1U);
  EXPECT_LE(support_polygon(same).count, 2U);
  EXPECT_EQ(support_polygon(line).count, 2U);
  EXPECT_DOUBLE_EQ(projected_margin(support_polygon(line), {1, 1, 9}), 0.0);
  EXPECT_DOUBLE_EQ(projected_margin(support_polygon(line), {3, 2, 9}), -1.0);
  EXPECT_EQ(projected_margin(support_polygon({}), {0, 0, 0}), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(nesm(support_polygon(line), {1, 1, 9}).value, -std::numeric_limits<double>::infinity());
  EXPECT_THROW(support_polygon(std::vector<Vector3d>(33, Vector3d::Zero())), std::invalid_argument);
}

TEST(ProjectedMargin, OfASquareInClosedForm) {
  const std::vector<Vector3d> square{{0, 0, 0}, {1, 0, 0.2}, {1, 1, -0.3}, {0, 1, 0}};
  const SupportPolygon polygon = support_polygon(square);
  EXPECT_DOUBLE_EQ(projected_margin(polygon, {0.5, 0.3, 7}), 0.3);
  EXPECT_DOUBLE_EQ(projected_margin(polygon, {1.5, 0.3, 7}), -0.5);
  EXPECT_DOUBLE_EQ(projected_margin(polygon, {1.3, 1.4, 7}), -0.5);
}

TEST(Nesm, OfALevelSquareInClosedForm) {
  const std::vector<Vector3d> square{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  EXPECT_NEAR(nesm(support_polygon(square), {0, 0, 2}).value, std::sqrt(5.0) - 2.0, 1e-15);
  EXPECT_NEAR(nesm(support_polygon(square), {0.5, 0, 2}).value, std::hypot(2, 0.5) - 2.0, 1e-15);
  EXPECT_NEAR(nesm(support_polygon(square), {1.5, 0, 2}).value, 2.0 - std::hypot(2, 0.5), 1e-15) << "outside: negative";
}

TEST(Nesm, OfAnInclinedEdgeIsTheRiseOfTheCentreOfMassWhileTheRobotTips) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> place(-0.3, 0.3), height(-0.1, 0.6);
  int below = 0;
  for (int i = 0; i < 60; ++i) {
    const std::vector<Vector3d> ends = random_points(random, 2);
    const Vector3d com(place(random), place(random), height(random));
    const double margin = nesm_of_edge(ends[0], ends[1], com);
    EXPECT_NEAR(std::abs(margin), rise_by_turning(ends[0], ends[1], com), 1e-9);
    const double left = (ends[1] - ends[0]).x() * (com - ends[0]).y() - (ends[1] - ends[0]).y() * (com - ends[0]).x();
    EXPECT_EQ(margin > 0.0, left > 0.0);
    below += margin > 0.0 && com.z() < std::min(ends[0].z(), ends[1].z());
  }
  EXPECT_GT(below, 0) << "the centre of mass also hung below the edge, where an arc sine would fold the angle";
}

TEST(Nesm, OfTheWholeIsTheLeastOverTheEdges) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 500; ++i) {
    const std::vector<Vector3d> points = random_points(random, 3 + random() % 5);
    const Vector3d com(0.02, -0.03, 0.3);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : edges_by_definition(points)) least = std::min(least, nesm_of_edge(a, b, com));
    const Nesm found = nesm(support_polygon(points), com);
    ASSERT_DOUBLE_EQ(found.value, least);
  }
}

}  // namespace
}  // namespace foothold::contact
