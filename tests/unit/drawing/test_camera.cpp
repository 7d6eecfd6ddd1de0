// The two projections against closed forms.
#include "camera.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace foothold::drawing {
namespace {

TEST(Camera, FromAboveXGoesRightAndYGoesUp) {
  const Projection above{camera_above(), {1.0, 2.0, 3.0}, {400.0, 300.0}, 100.0};
  EXPECT_TRUE(above({1.0, 2.0, 3.0}).isApprox(Vector3d(400.0, 300.0, 0.0)));
  EXPECT_TRUE(above({2.0, 2.5, 3.25}).isApprox(Vector3d(500.0, 250.0, 25.0)));
}

TEST(Camera, ObliqueViewAgreesWithItsClosedForm) {
  // Eye at azimuth -90 deg, elevation 30 deg: x stays, y is seen by sin 30, z by cos 30.
  const Projection seen{camera_oblique(-90.0, 30.0), Vector3d::Zero(), {0.0, 0.0}, 10.0};
  EXPECT_TRUE(seen({1.0, 0.0, 0.0}).isApprox(Vector3d(10.0, 0.0, 0.0), 1e-12));
  EXPECT_TRUE(seen({0.0, 1.0, 0.0}).isApprox(Vector3d(0.0, -5.0, -10.0 * std::sqrt(3.0) / 2.0), 1e-12));
  EXPECT_TRUE(seen({0.0, 0.0, 1.0}).isApprox(Vector3d(0.0, -10.0 * std::sqrt(3.0) / 2.0, 5.0), 1e-12));
}

TEST(Camera, AxesAreRightHandedAndUnitForEveryEye) {
  for (double azimuth = -360.0; azimuth <= 360.0; azimuth += 45.0)
    for (double elevation = -90.0; elevation <= 90.0; elevation += 30.0) {
      const Camera c = camera_oblique(azimuth, elevation);
      EXPECT_TRUE(c.right.cross(c.up).isApprox(c.towards, 1e-12)) << azimuth << ' ' << elevation;
      EXPECT_NEAR(c.right.norm(), 1.0, 1e-12);
      EXPECT_NEAR(c.up.norm(), 1.0, 1e-12);
      EXPECT_GE(c.up.z(), -1e-12);
    }
}

TEST(Camera, ReachIsThatOfTheProjectedPoints) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> some(-2.0, 2.0);
  const Camera camera = camera_oblique(-60.0, 30.0);
  Points points;
  for (int i = 0; i < 50; ++i) points.emplace_back(some(random), some(random), some(random));
  const Reach all = reach(camera, points);
  const Projection seen{camera, all.centre, {0.0, 0.0}, 1.0};
  const Box2 box = flat_bounds(seen(points));
  EXPECT_NEAR(box.high.x(), all.width / 2.0, 1e-12);
  EXPECT_NEAR(box.low.x(), -all.width / 2.0, 1e-12);
  EXPECT_NEAR(box.high.y(), all.height / 2.0, 1e-12);
  EXPECT_NEAR(box.low.y(), -all.height / 2.0, 1e-12);
}

TEST(Camera, FarFromTheOriginNoDigitIsLost) {
  const Vector3d far(1e6, -1e6, 1e3);
  const Reach all = reach(camera_above(), {far, far + Vector3d(0.25, 0.5, 0.0)});
  EXPECT_NEAR(all.width, 0.25, 1e-9);
  EXPECT_NEAR(all.height, 0.5, 1e-9);
}

}  // namespace
}  // namespace foothold::drawing
