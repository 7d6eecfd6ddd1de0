// Generated terrains: what the paper says of its own, the same from the same seed, the files that are shipped.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "terrains.hpp"

namespace foothold::terrain {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
const double kSlides = std::atan(0.4);                                             // where a body begins to slide at friction 0.4
const double kSlidesOnPyramid = std::atan(0.4 * std::cos(std::numbers::pi / 10));  // with ten edges inside the cone: 20.83 deg

double slope_at(const Surface& surface, double x, double y) {
  return slope(surface.terrain(), surface.beneath({x, y, 2.0}).value().triangle);
}

TEST(Ramps, AreFortyTwoTrianglesOfTheSizeThatThePaperTells) {
  const Terrain terrain = ramps();
  EXPECT_EQ(terrain.size(), 42u);
  Eigen::AlignedBox3d bounds;
  for (const Vector3d& v : terrain.vertices) bounds.extend(v);
  EXPECT_TRUE(bounds.min().isApprox(Vector3d(-1.0, -1.0, -0.5)));
  EXPECT_TRUE(bounds.max().isApprox(Vector3d(1.0, 1.0, 0.4)));
  EXPECT_EQ(subdivide(terrain, 0.2).size(), 1116u);  // the paper: 1176
}

TEST(Ramps, BearThePapersThreePoints) {
  const Terrain terrain = ramps();
  const Surface surface(terrain);
  for (const Vector3d& p : {Vector3d(0, 0, -0.5), Vector3d(0, 0.75, -0.2), Vector3d(-1, -0.4, 0.2)}) {
    EXPECT_LT(surface.nearest(p).distance, 1e-12);
    EXPECT_NEAR(surface.height(p.x(), p.y()).value_or(9.0), p.z(), 1e-12);
  }
}

TEST(Ramps, CoverTheSquareOnceWithoutGapOrFold) {
  const Terrain terrain = ramps();
  double seen_from_above = 0.0;
  for (int t = 0; t < 42; ++t) seen_from_above += area(terrain, t) * terrain.normals[static_cast<std::size_t>(t)].z();
  EXPECT_NEAR(seen_from_above, 4.0, 1e-12);
  int borders = 0;
  for (int t = 0; t < 42; ++t) borders += 3 - static_cast<int>(terrain.neighbours(t).size());
  EXPECT_EQ(borders, 12);  // sides along the square's edges
}

TEST(Ramps, CanBeWalkedUpInTurnAndNoOtherWay) {
  const Terrain terrain = ramps();
  const Surface surface(terrain);
  EXPECT_NEAR(slope_at(surface, 0.7, 0.1) / kDegree, 14.53, 0.01);
  EXPECT_NEAR(slope_at(surface, 0.1, 0.7) / kDegree, 6.34, 0.01);
  EXPECT_NEAR(slope_at(surface, -0.7, -0.1) / kDegree, 18.43, 0.01);
  EXPECT_LT(18.44 * kDegree, kSlidesOnPyramid);
  // Gentle triangles hang together from the floor to the top only by the ramps: without the second one, the top is out of reach.
  const auto reached = [&](bool second) {
    std::vector<bool> seen(terrain.size(), false);
    std::vector<int> open{surface.nearest({0, 0, -0.5}).triangle};
    seen[static_cast<std::size_t>(open[0])] = true;
    for (std::size_t k = 0; k < open.size(); ++k)
      for (const int n : terrain.neighbours(open[k])) {
        const Vector3d& c = terrain.centroids[static_cast<std::size_t>(n)];
        const bool on_second = c.y() > 0.6 && std::abs(c.x()) < 0.6;
        if (seen[static_cast<std::size_t>(n)] || slope(terrain, n) > kSlidesOnPyramid || (on_second && !second)) continue;
        seen[static_cast<std::size_t>(n)] = true;
        open.push_back(n);
      }
    return static_cast<bool>(seen[static_cast<std::size_t>(surface.nearest({-1, -0.4, 0.2}).triangle)]);
  };
  EXPECT_TRUE(reached(true));
  EXPECT_FALSE(reached(false));
  // All others are well beyond what friction holds.
  for (int t = 0; t < 42; ++t)
    if (slope(terrain, t) > kSlidesOnPyramid) {
      EXPECT_GT(slope(terrain, t), kSlides + 12.0 * kDegree);
      EXPECT_LT(slope(terrain, t), 62.0 * kDegree);
    }
}

TEST(Generate, GivesTheSameBytesForTheSameSeedAndOthersForAnother) {
  for (const Family family : {Family::kBoulders, Family::kStairs, Family::kDitch}) {
    Options options;
    options.size = 2.0;
    const std::string first = to_yaml(generate(family, options));
    EXPECT_EQ(to_yaml(generate(family, options)), first);
    options.seed = 2;
    EXPECT_NE(to_yaml(generate(family, options)), first);
  }
}

TEST(Generate, MakesOneSurfaceOfTheSizeAskedFor) {
  for (const Family family : {Family::kBoulders, Family::kStairs, Family::kDitch})
    for (const double size : {1.0, 2.5, 6.0})
      for (std::uint64_t seed = 0; seed < 8; ++seed) {
        Options options{seed, size, 0.2};
        const Terrain terrain = generate(family, options);
        double seen_from_above = 0.0;
        for (int t = 0; t < static_cast<int>(terrain.size()); ++t)
          seen_from_above += area(terrain, t) * terrain.normals[static_cast<std::size_t>(t)].z();
        EXPECT_NEAR(seen_from_above, size * size, 1e-9);
        std::vector<bool> seen(terrain.size(), false);
        std::vector<int> open{0};
        seen[0] = true;
        for (std::size_t k = 0; k < open.size(); ++k)
          for (const int n : terrain.neighbours(open[k]))
            if (!seen[static_cast<std::size_t>(n)]) {
              seen[static_cast<std::size_t>(n)] = true;
              open.push_back(n);
            }
        EXPECT_EQ(open.size(), terrain.size());
      }
}

TEST(Generate, MakesStairsWithRisersThatNoFootStandsOn) {
  const Terrain terrain = generate(Family::kStairs, {});
  std::size_t walls = 0;
  for (std::size_t t = 0; t < terrain.size(); ++t) {
    EXPECT_EQ(terrain.ground[t] != 0, terrain.normals[t].z() > 0.5);
    walls += terrain.ground[t] == 0 ? 1 : 0;
  }
  EXPECT_EQ(walls, terrain.size() / 2 - 1);
}

TEST(Generate, MakesADitchThatIsDeepButForItsCrossing) {
  const Terrain terrain = generate(Family::kDitch, {});
  const Surface surface(terrain);
  double shallowest = -9.0, deepest = 9.0;
  for (double y = -2.0; y <= 2.0; y += 0.05) {
    const double z = surface.height(0.0, y).value();
    shallowest = std::max(shallowest, z), deepest = std::min(deepest, z);
  }
  EXPECT_LT(deepest, -0.45);
  EXPECT_GT(shallowest, -0.15);
}

// From one bank to the other over gentle triangles; the rest of the ditch is too steep.
TEST(Generate, MakesADitchThatCanBeCrossed) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Terrain terrain = generate(Family::kDitch, {seed, 4.0, 0.16});
    const Surface surface(terrain);
    std::vector<bool> seen(terrain.size(), false);
    std::vector<int> open{surface.beneath({-1.5, 0.0, 2.0}).value().triangle};
    double steepest = 0.0;
    for (std::size_t k = 0; k < open.size(); ++k)
      for (const int n : terrain.neighbours(open[k])) {
        if (seen[static_cast<std::size_t>(n)]) continue;
        seen[static_cast<std::size_t>(n)] = true;
        steepest = std::max(steepest, slope(terrain, n));
        if (slope(terrain, n) < kSlidesOnPyramid) open.push_back(n);
      }
    EXPECT_TRUE(seen[static_cast<std::size_t>(surface.beneath({1.5, 0.0, 2.0}).value().triangle)]) << "seed " << seed;
    EXPECT_GT(steepest, kSlides + 5.0 * kDegree) << "seed " << seed;
  }
}

TEST(Generate, RefusesOptionsOutOfRange) {
  EXPECT_THROW(generate(Family::kBoulders, {1, 0.5, 0.1}), std::invalid_argument);
  EXPECT_THROW(generate(Family::kBoulders, {1, 101.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(generate(Family::kDitch, {1, 4.0, 0.001}), std::invalid_argument);
  EXPECT_THROW(generate(Family::kDitch, {1, 50.0, 0.01}), std::invalid_argument);
  EXPECT_THROW(generate(Family::kDitch, {1, NAN, 0.1}), std::invalid_argument);
}

TEST(Generate, KnowsItsFamiliesByName) {
  EXPECT_EQ(family_named("ramps"), Family::kRamps);
  EXPECT_EQ(family_named("boulders"), Family::kBoulders);
  EXPECT_EQ(family_named("stairs"), Family::kStairs);
  EXPECT_EQ(family_named("ditch"), Family::kDitch);
  EXPECT_FALSE(family_named("lake").has_value());
}

// The files as first written, so that another machine or library that draws otherwise is noticed.
TEST(Generate, MadeTheScenesThatAreShipped) {
  for (const char* name : {"ramps", "boulders", "stairs", "ditch"}) {
    const Terrain shipped = read_terrain(std::string(FOOTHOLD_SCENES) + "/terrain-" + name + ".yaml");
    const Terrain made = generate(family_named(name).value(), {});
    EXPECT_EQ(shipped.vertices, made.vertices) << name;
    EXPECT_EQ(shipped.triangles, made.triangles) << name;
  }
}

}  // namespace
}  // namespace foothold::terrain
