// Distances to triangles, against the toolkit's closed forms, which are written apart.
#include <gtest/gtest.h>

#include "collision/distance.hpp"
#include "octopod/check/nearby.hpp"
#include "robot.hpp"
#include "terrain/surface.hpp"

namespace foothold::octopod {
namespace {

Triangle triangle_of(const std::array<Vector3d, 3>& corners) {
  Triangle out;
  out.corners = corners;
  out.normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  for (const Vector3d& corner : corners) out.bounds.extend(corner);
  return out;
}

TEST(Nearby, DistancesAreTheToolkits) {
  std::mt19937_64 random(3);
  int meeting = 0;
  for (int run = 0; run < 20000; ++run) {
    const std::array<Vector3d, 3> corners{random_vector(random, 0.5), random_vector(random, 0.5), random_vector(random, 0.5)};
    const Triangle t = triangle_of(corners);
    const collision::Patch patch{corners};
    const Vector3d a = random_vector(random, 0.7), b = random_vector(random, 0.7);
    EXPECT_NEAR(distance(a, t), (terrain::nearest_on_triangle(a, corners[0], corners[1], corners[2]) - a).norm(), 1e-9);
    EXPECT_NEAR(distance(a, b, t), collision::distance(collision::Capsule{a, b, 0.0}, patch), 1e-9);
    Isometry3d pose = Isometry3d::Identity();
    pose.translation() = random_vector(random, 0.7);
    pose.linear() = random_rotation(random).toRotationMatrix();
    const Vector3d half = random_vector(random, 0.3).cwiseAbs();
    const double expected = collision::distance(collision::Box{pose, half}, patch);
    EXPECT_NEAR(distance(pose, half, t), expected, 1e-9);
    meeting += expected == 0.0 ? 1 : 0;
  }
  EXPECT_GT(meeting, 1000);
}

TEST(Nearby, FindsATriangleThatRunsThroughABoxFarFromItsEdges) {
  const Triangle sheet = triangle_of({Vector3d(-9.0, -9.0, 0.0), Vector3d(9.0, -9.0, 0.0), Vector3d(0.0, 9.0, 0.0)});
  const Triangle needle = triangle_of({Vector3d(0.01, 0.0, -5.0), Vector3d(-0.01, 0.0, -5.0), Vector3d(0.0, 0.0, 5.0)});
  const Vector3d half(0.5, 0.5, 0.5);
  EXPECT_EQ(distance(Isometry3d::Identity(), half, sheet), 0.0);
  EXPECT_EQ(distance(Isometry3d::Identity(), half, needle), 0.0);
}

}  // namespace
}  // namespace foothold::octopod
