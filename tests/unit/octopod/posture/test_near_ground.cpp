// Bodies and feet near the ground: the same answers by planes as triangle by triangle, and how a foot may come from its sole.
#include <gtest/gtest.h>

#include "grounds.hpp"
#include "octopod/posture/near_ground.hpp"

namespace foothold::octopod {
namespace {

const collision::Bounds kAll{Vector3d(-9, -9, -9), Vector3d(9, 9, 9)};

TEST(OctopodNearGround, SaysOfEveryBodyWhatTheSurfaceSays) {
  std::mt19937_64 random(11);
  for (const int cells : {2, 4, 12}) {
    const auto ground = ground_of(1.0, cells, [&](double, double) { return uniform(random, 0, 0.3); });
    const NearGround near(ground->surface, kAll);
    int touched = 0;
    for (int i = 0; i < 3000; ++i) {
      const double clearance = i % 3 == 0 ? 0.0 : uniform(random, 0, 0.05);
      const Vector3d at = random_vector(random, 0.5) + Vector3d(0, 0, 0.4);
      const collision::Capsule capsule{at, at + random_vector(random, 0.1), 0.01};
      Isometry3d pose = Isometry3d::Identity();
      pose.translation() = at;
      pose.linear() = random_rotation(random).toRotationMatrix();
      const collision::Box box{pose, {0.1, 0.08, 0.025}};
      EXPECT_EQ(near.nearer(capsule, clearance), ground->surface.nearer(capsule, clearance));
      EXPECT_EQ(near.nearer(box, clearance), ground->surface.nearer(box, clearance));
      touched += near.nearer(box, clearance);
    }
    EXPECT_GT(touched, 300);
    EXPECT_LT(touched, 2700);
  }
}

// A sheet folded along the Y axis: it falls by `fall` (1) to both sides.
std::unique_ptr<TestGround> folded(double fall) {
  return ground_of(1.0, 1, [&](double x, double) { return -fall * std::abs(x); });
}

TEST(OctopodNearGround, AFootComesFromOutside) {
  const auto ground = level_ground();
  const NearGround near(ground->surface, kAll);
  const Vector3d sole(0.01, 0.02, 0.0);
  EXPECT_TRUE(near.foot_free(sole, sole + Vector3d(0, 0, 0.03)));
  EXPECT_TRUE(near.foot_free(sole, sole + Vector3d(0.0299, 0, 0.001)));
  EXPECT_FALSE(near.foot_free(sole, sole + Vector3d(0.03, 0, -0.001)));
  EXPECT_TRUE(near.foot_free(sole + Vector3d(0, 0, 0.01), sole + Vector3d(0, 0, 0.04))) << "a foot in the air";
  EXPECT_FALSE(near.foot_free(sole - Vector3d(0, 0, 0.01), sole + Vector3d(0, 0, 0.02)));
}

TEST(OctopodNearGround, OnARidgeOneSideIsEnoughInAHollowAllCount) {
  const auto ridge = folded(1.0), hollow = folded(-1.0);
  const NearGround on_ridge(ridge->surface, kAll), in_hollow(hollow->surface, kAll);
  const Vector3d sole(0, 0.3, 0), up(0, 0, 0.03), aside(0.03, 0, 0.001), below(0.01, 0, -0.028);
  EXPECT_TRUE(on_ridge.foot_free(sole, sole + up));
  EXPECT_TRUE(on_ridge.foot_free(sole, sole + aside)) << "above one flank, below the plane of the other";
  EXPECT_FALSE(on_ridge.foot_free(sole, sole + below));
  EXPECT_TRUE(in_hollow.foot_free(sole, sole + up));
  EXPECT_FALSE(in_hollow.foot_free(sole, sole + aside));
}

TEST(OctopodNearGround, AFootDoesNotCutOtherGround) {
  const TestGround two(terrain::make_terrain(
      mesh::joined({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {-1, -1, 0.02}, {1, -1, 0.02}, {0, 1, 0.02}}, {{0, 1, 2}, {3, 4, 5}})));
  const NearGround near(two.surface, kAll);
  EXPECT_FALSE(near.foot_free({0, 0, 0}, {0, 0, 0.03}));
  EXPECT_TRUE(near.foot_free({0, 0, 0.02}, {0, 0, 0.05}));
}

}  // namespace
}  // namespace foothold::octopod
