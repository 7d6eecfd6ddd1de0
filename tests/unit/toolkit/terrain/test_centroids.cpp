// The k-d tree of centroids against sorting them all; the paper's foothold against its words, and where it errs.
#include "terrain/centroids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "terrains.hpp"

namespace foothold::terrain {
namespace {

std::vector<int> by_distance(const Terrain& terrain, const Vector3d& p) {
  std::vector<int> out;
  for (int t = 0; t < static_cast<int>(terrain.size()); ++t)
    if (terrain.ground[static_cast<std::size_t>(t)] != 0) out.push_back(t);
  std::stable_sort(out.begin(), out.end(), [&](int a, int b) {
    return (terrain.centroids[static_cast<std::size_t>(a)] - p).squaredNorm() <
           (terrain.centroids[static_cast<std::size_t>(b)] - p).squaredNorm();
  });
  return out;
}

TEST(Centroids, AreFoundInTheOrderOfTheirDistance) {
  std::mt19937_64 random(1);
  for (const Terrain& whole : some_terrains()) {
    const Terrain terrain = subdivide(whole, 0.2);
    const CentroidTree tree(terrain);
    for (int trial = 0; trial < 200; ++trial) {
      const Vector3d p = point_about(terrain, random);
      const std::vector<int> all = by_distance(terrain, p);
      EXPECT_EQ(tree.nearest(p, 10), std::vector<int>(all.begin(), all.begin() + 10));
      const double radius = uniform(random, 0.0, 0.5);
      const auto inside = std::find_if(all.begin(), all.end(), [&](int t) {
        return (terrain.centroids[static_cast<std::size_t>(t)] - p).squaredNorm() >= radius * radius;
      });
      EXPECT_EQ(tree.within(p, radius), std::vector<int>(all.begin(), inside));
    }
    EXPECT_EQ(tree.nearest(Vector3d::Zero(), terrain.size() + 5).size(), by_distance(terrain, Vector3d::Zero()).size());
    EXPECT_TRUE(tree.nearest(Vector3d::Zero(), 0).empty());
  }
}

TEST(Centroids, GiveTheNearestOfThoseWithinTheRadiusAsFoothold) {
  std::mt19937_64 random(2);
  const Terrain terrain = subdivide(ramps(), 0.2);
  const Surface surface(terrain);
  const CentroidTree tree(terrain);
  int none = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Vector3d shoulder = point_about(terrain, random), foot = shoulder + 0.2 * Vector3d(uniform(random, -1, 1), 0.3, -0.5);
    double wanted = INFINITY;
    for (const int t : tree.within(shoulder, 0.3))
      wanted = std::min(
          wanted, (nearest_on_triangle(foot, terrain.corner(t, 0), terrain.corner(t, 1), terrain.corner(t, 2)) - foot).norm());
    const Nearest found = tree.foothold(foot, shoulder, 0.3);
    EXPECT_EQ(found.triangle >= 0, std::isfinite(wanted));
    none += found.triangle < 0 ? 1 : 0;
    if (found.triangle < 0) continue;
    EXPECT_EQ(found.distance, wanted);
    EXPECT_GE(found.distance, surface.nearest(foot).distance - 1e-12);
  }
  EXPECT_GT(none, 100);
}

// The centroid of a triangle of 2 m is out of every leg's reach, though the foot stands on it: why the paper must cut fine.
TEST(Centroids, MissLargeTrianglesThatTheSurfaceFinds) {
  const Terrain terrain = ramps();
  const CentroidTree tree(terrain);
  const Vector3d foot(0.9, -0.95, -0.45), shoulder(0.9, -0.95, -0.35);
  EXPECT_EQ(tree.foothold(foot, shoulder, 0.3).triangle, -1);
  EXPECT_NEAR(Surface(terrain).nearest(foot).distance, 0.05, 1e-12);
}

}  // namespace
}  // namespace foothold::terrain
