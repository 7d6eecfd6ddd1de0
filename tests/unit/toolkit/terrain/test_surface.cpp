// The tree's answers against all triangles one by one, and against what is known of a wedge.
#include "terrain/surface.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "terrains.hpp"

namespace foothold::terrain {
namespace {

// By another way than the regions: the foot in the plane if it is inside, else the nearest of the three sides.
double distance_to_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d normal = (b - a).cross(c - a).normalized();
  const std::array<Vector3d, 3> corner{a, b, c};
  bool inside = true;
  double best = INFINITY;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3d side = corner[(k + 1) % 3] - corner[k];
    inside = inside && normal.dot(side.cross(p - corner[k])) >= 0.0;
    const double share = std::clamp((p - corner[k]).dot(side) / side.squaredNorm(), 0.0, 1.0);
    best = std::min(best, (corner[k] + share * side - p).norm());
  }
  return inside ? std::abs(normal.dot(p - a)) : best;
}

double distance_to_all(const Terrain& terrain, const Vector3d& p, bool ground_only) {
  double best = INFINITY;
  for (int t = 0; t < static_cast<int>(terrain.size()); ++t)
    if (!ground_only || terrain.ground[static_cast<std::size_t>(t)] != 0)
      best = std::min(best, distance_to_triangle(p, terrain.corner(t, 0), terrain.corner(t, 1), terrain.corner(t, 2)));
  return best;
}

// Point of a line and a plane, then inside by the three sides; the nearest of them all.
double ray_to_all(const Terrain& terrain, const Vector3d& origin, const Vector3d& direction, double& margin) {
  double best = INFINITY;
  for (int t = 0; t < static_cast<int>(terrain.size()); ++t) {
    const Vector3d& normal = terrain.normals[static_cast<std::size_t>(t)];
    const double at = normal.dot(terrain.corner(t, 0) - origin) / normal.dot(direction);
    if (!std::isfinite(at)) continue;
    const Vector3d p = origin + at * direction;
    double least = INFINITY;  // how far inside
    for (int k = 0; k < 3; ++k) {
      const Vector3d side = terrain.corner(t, (k + 1) % 3) - terrain.corner(t, k);
      least = std::min(least, normal.dot(side.cross(p - terrain.corner(t, k))) / side.norm());
    }
    margin = std::min({margin, std::abs(least), std::abs(at)});
    if (at >= 0.0 && least >= 0.0) best = std::min(best, at);
  }
  return best;
}

TEST(Surface, FindsTheNearestPointAsTryingAllTrianglesDoes) {
  std::mt19937_64 random(1);
  for (const Terrain& terrain : some_terrains()) {
    const Surface surface(terrain);
    for (int trial = 0; trial < 2000; ++trial) {
      const Vector3d p = point_about(terrain, random);
      for (const Among among : {Among::kGround, Among::kAll}) {
        const Nearest found = surface.nearest(p, among);
        const double wanted = distance_to_all(terrain, p, among == Among::kGround);
        ASSERT_GE(found.triangle, 0);
        EXPECT_NEAR(found.distance, wanted, 1e-12);
        EXPECT_NEAR((found.point - p).norm(), wanted, 1e-12);
        EXPECT_LT(distance_to_triangle(found.point, terrain.corner(found.triangle, 0), terrain.corner(found.triangle, 1),
                                       terrain.corner(found.triangle, 2)),
                  1e-12);
        EXPECT_TRUE(among == Among::kAll || terrain.ground[static_cast<std::size_t>(found.triangle)] != 0);
        EXPECT_EQ(surface.nearest(p, among, wanted * 1.0001 + 1e-9).triangle, found.triangle);
        EXPECT_EQ(surface.nearest(p, among, wanted * 0.9999 - 1e-9).triangle, -1);
      }
    }
  }
}

TEST(Surface, MeetsRaysAsTryingAllTrianglesDoes) {
  std::mt19937_64 random(2);
  int hits = 0, compared = 0;
  for (const Terrain& terrain : some_terrains()) {
    const Surface surface(terrain);
    for (int trial = 0; trial < 3000; ++trial) {
      const Vector3d origin = point_about(terrain, random);
      const Vector3d direction = (point_about(terrain, random) - origin).normalized();
      double margin = INFINITY;
      const double wanted = ray_to_all(terrain, origin, direction, margin);
      if (margin < 1e-9) continue;  // along an edge
      ++compared;
      const auto found = surface.ray(origin, direction);
      ASSERT_EQ(found.has_value(), std::isfinite(wanted));
      if (!found) continue;
      ++hits;
      EXPECT_NEAR(found->distance, wanted, 1e-9);
      EXPECT_LT((found->point - origin - wanted * direction).norm(), 1e-9);
      EXPECT_TRUE(surface.ray(origin, direction, wanted + 1e-9).has_value());
      EXPECT_FALSE(surface.ray(origin, direction, wanted - 1e-9).has_value());
    }
  }
  EXPECT_GT(hits, 2000);
  EXPECT_GT(compared, 11000);
}

// The square is covered without a gap, so straight down there is always something: at edges, corners, in the middle.
TEST(Surface, LetsNoPlumbLineThroughBetweenTriangles) {
  std::mt19937_64 random(3);
  for (const Terrain& whole : {ramps(), generate(Family::kBoulders, {7, 2.0, 0.2})}) {
    const Terrain terrain = subdivide(whole, 0.1);
    const Surface surface(terrain);
    std::vector<Vector3d> above;
    for (int t = 0; t < static_cast<int>(terrain.size()); ++t)
      for (int k = 0; k < 3; ++k) {
        above.push_back(terrain.corner(t, k));
        above.push_back(0.3 * terrain.corner(t, k) + 0.7 * terrain.corner(t, (k + 1) % 3));
      }
    for (int trial = 0; trial < 5000; ++trial) above.emplace_back(uniform(random, -1, 1), uniform(random, -1, 1), 0.0);
    for (const Vector3d& p : above) {
      const double x = std::clamp(p.x(), -1.0, 1.0), y = std::clamp(p.y(), -1.0, 1.0);
      const auto beneath = surface.beneath({x, y, 3.0});
      ASSERT_TRUE(beneath.has_value()) << x << " " << y;
      EXPECT_NEAR(surface.height(x, y).value(), beneath->point.z(), 1e-11);
      EXPECT_LT(surface.nearest(beneath->point).distance, 1e-11);
      EXPECT_TRUE(surface.under(beneath->point - Vector3d(0, 0, 1e-6)));
      EXPECT_FALSE(surface.under(beneath->point + Vector3d(0, 0, 1e-6)));
      EXPECT_TRUE(surface.beneath(beneath->point).has_value());  // a point on the surface stands on it
    }
  }
}

TEST(Surface, KnowsWhatIsBesideAboveAndUnder) {
  const Terrain terrain = ramps();
  const Surface surface(terrain);
  EXPECT_FALSE(surface.beneath({1.1, 0, 3}).has_value());
  EXPECT_FALSE(surface.height(0, -1.001).has_value());
  EXPECT_FALSE(surface.beneath({0, 0, -0.6}).has_value());
  EXPECT_NEAR(surface.beneath({0, 0, 0.25})->distance, 0.75, 1e-12);
  EXPECT_NEAR(surface.height(-1, -1).value(), 0.4, 1e-12);
  EXPECT_FALSE(surface.under({0, 0, 0}));
  EXPECT_TRUE(surface.under({0, 0, -0.6}));
  EXPECT_FALSE(surface.under({2, 0, -0.6}));
}

// A table: in the space beneath its top nothing is under the ground, in the top it is.
TEST(Surface, KnowsWhatIsUnderAnOverhang) {
  std::vector<Vector3d> corner;
  for (const double z : {0.5, 0.6})
    for (const double y : {-1.0, 1.0})
      for (const double x : {-1.0, 1.0}) corner.emplace_back(x, y, z);
  std::vector<std::array<int, 3>> box{{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                      {1, 3, 7}, {1, 7, 5}, {3, 2, 6}, {3, 6, 7}, {2, 0, 4}, {2, 4, 6}};
  const int first = static_cast<int>(corner.size());
  for (const double y : {-2.0, 2.0})
    for (const double x : {-2.0, 2.0}) corner.emplace_back(x, y, 0.0);
  box.push_back({first, first + 1, first + 3});
  box.push_back({first, first + 3, first + 2});
  const Terrain terrain = make_terrain(mesh::joined(corner, box));
  EXPECT_EQ(std::count(terrain.ground.begin(), terrain.ground.end(), 1), 4);  // the floor and the table's top
  const Surface surface(terrain);
  EXPECT_FALSE(surface.under({0.1, 0, 0.3}));
  EXPECT_TRUE(surface.under({0.1, 0, 0.55}));
  EXPECT_FALSE(surface.under({0.1, 0, 0.7}));
  EXPECT_TRUE(surface.under({1.5, 0, -0.1}));
  // From close below the top, the nearest ground is the top's upper side, not its lower one, which no foot stands on.
  EXPECT_NEAR(surface.nearest({0.1, 0, 0.45}).point.z(), 0.6, 1e-12);
  EXPECT_NEAR(surface.nearest({0.1, 0, 0.45}, Among::kAll).point.z(), 0.5, 1e-12);
}

template <class Body>
void expect_as_all(const Surface& surface, const Body& body) {
  const Terrain& terrain = surface.terrain();
  double wanted = INFINITY;
  for (int t = 0; t < static_cast<int>(terrain.size()); ++t) {
    const std::array<Vector3d, 3> corners{terrain.corner(t, 0), terrain.corner(t, 1), terrain.corner(t, 2)};
    wanted = std::min(wanted, collision::distance(body, collision::Patch{corners}));
  }
  EXPECT_NEAR(surface.distance(body), wanted, 1e-12);
  EXPECT_TRUE(surface.nearer(body, wanted + 1e-6));
  EXPECT_FALSE(wanted > 1e-6 && surface.nearer(body, wanted - 1e-6));
}

TEST(Surface, IsAsFarFromBodiesAsTheNearestOfAllTriangles) {
  std::mt19937_64 random(4);
  for (const Terrain& terrain : some_terrains()) {
    const Surface surface(terrain);
    for (int trial = 0; trial < 200; ++trial) {
      const Vector3d p = point_about(terrain, random);
      expect_as_all(surface, Capsule{p, p + 0.1 * (point_about(terrain, random) - p), uniform(random, 0.0, 0.05)});
      Box box;
      box.pose.translation() = p;
      box.pose.linear() = Eigen::AngleAxisd(uniform(random, 0, 3), Vector3d(1, uniform(random, -1, 1), 0.3).normalized()).matrix();
      box.half = {0.1, 0.08, 0.025};
      expect_as_all(surface, box);
    }
  }
}

TEST(Surface, NamesTheTrianglesThatBoundsTouch) {
  std::mt19937_64 random(5);
  const Terrain terrain = subdivide(ramps(), 0.2);
  const Surface surface(terrain);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3d p = point_about(terrain, random);
    const collision::Bounds query(p - Vector3d::Constant(0.1), p + Vector3d::Constant(0.1));
    std::vector<int> found = surface.touching(query), wanted;
    std::sort(found.begin(), found.end());
    for (int t = 0; t < static_cast<int>(terrain.size()); ++t) {
      collision::Bounds bounds;
      for (int k = 0; k < 3; ++k) bounds.extend(terrain.corner(t, k));
      if (bounds.intersects(query)) wanted.push_back(t);
    }
    EXPECT_EQ(found, wanted);
  }
}

}  // namespace
}  // namespace foothold::terrain
