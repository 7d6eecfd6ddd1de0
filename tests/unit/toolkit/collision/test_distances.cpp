// Distances against the certificate of the least norm.
#include <gtest/gtest.h>

#include "least_norm.hpp"
#include "pairs.hpp"

namespace foothold::collision {
namespace {

constexpr double kError = 1e-9;  // m, as the header promises

// The oracle's bracket, less the radii.
void expect_within(double distance, const Bracket& hulls, double radii, int& wide, const char* what, int k) {
  const double low = std::max(0.0, hulls.low - radii), high = std::max(0.0, hulls.high - radii);
  wide += high - low > kError;
  EXPECT_GE(distance, low - kError) << what << " " << k;
  EXPECT_LE(distance, high + kError) << what << " " << k;
}

class Distances : public testing::TestWithParam<Kind> {};

TEST_P(Distances, LieBetweenTheBoundsOfTheLeastNorm) {
  Pairs pairs(GetParam());
  int wide = 0, apart = 0;
  constexpr int kPairs = 20000;
  for (int k = 0; k < kPairs; ++k) {
    const Capsule c = pairs.capsule(), d = pairs.capsule();
    const Box b = pairs.box(), e = pairs.box();
    const std::vector<Vector3d> vertices = pairs.polygon();
    const Patch p{vertices};
    expect_within(distance(c, d), hull_distance(points_of(c), points_of(d)), c.radius + d.radius, wide, "capsules", k);
    expect_within(distance(c, b), hull_distance(points_of(c), points_of(b)), c.radius, wide, "capsule and box", k);
    expect_within(distance(b, e), hull_distance(points_of(b), points_of(e)), 0.0, wide, "boxes", k);
    expect_within(distance(c, p), hull_distance(points_of(c), points_of(p)), c.radius, wide, "capsule and patch", k);
    expect_within(distance(b, p), hull_distance(points_of(b), points_of(p)), 0.0, wide, "box and patch", k);
    apart += distance(b, e) > 0.0;
  }
  EXPECT_LT(wide, 5 * kPairs / 200) << "the oracle must be sharp to be one";
  EXPECT_GT(apart, kPairs / 10);
  EXPECT_LT(apart, 9 * kPairs / 10);
}

TEST_P(Distances, AreTheSameFromBothSides) {
  Pairs pairs(GetParam(), 2);
  for (int k = 0; k < 5000; ++k) {
    const Capsule c = pairs.capsule(), d = pairs.capsule();
    const Box b = pairs.box(), e = pairs.box();
    EXPECT_NEAR(distance(c, d), distance(d, c), kError);
    EXPECT_NEAR(distance(b, e), distance(e, b), kError);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Distances, testing::ValuesIn(kKinds));

TEST(Distance, OfTouchingBodiesIsZero) {
  const Box box{Isometry3d::Identity(), {1.0, 1.0, 1.0}};
  EXPECT_NEAR(distance(Capsule{{0.0, 0.0, 1.5}, {0.5, 0.0, 1.5}, 0.5}, box), 0.0, 1e-15);
  EXPECT_NEAR(distance(Box{Isometry3d(Eigen::Translation3d(2.0, 2.0, 2.0)), {1.0, 1.0, 1.0}}, box), 0.0, 1e-15);
  const std::vector<Vector3d> lid{{-2.0, -2.0, 1.0}, {2.0, -2.0, 1.0}, {0.0, 3.0, 1.0}};
  EXPECT_NEAR(distance(box, Patch{lid}), 0.0, 1e-15);
  EXPECT_NEAR(distance(Capsule{{0.0, 0.0, 1.25}, {0.0, 0.0, 2.0}, 0.25}, Patch{lid}), 0.0, 1e-15);
}

TEST(Distance, OfABodyInsideAnotherIsZero) {
  const Box box{Isometry3d::Identity(), {1.0, 1.0, 1.0}};
  EXPECT_EQ(distance(Box{Isometry3d::Identity(), {0.1, 0.2, 0.3}}, box), 0.0);
  EXPECT_EQ(distance(Capsule{{0.1, 0.0, 0.0}, {0.2, 0.1, 0.0}, 0.01}, box), 0.0);
  const std::vector<Vector3d> leaf{{-0.1, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}};
  EXPECT_EQ(distance(box, Patch{leaf}), 0.0);
}

// An edge of each goes through a face of the other, no corner of either is inside.
TEST(Distance, OfCrossedBarsIsZero) {
  const Box box{Isometry3d::Identity(), {1.0, 0.1, 0.1}};
  EXPECT_EQ(distance(Box{Isometry3d::Identity(), {0.1, 1.0, 0.05}}, box), 0.0);
  EXPECT_TRUE(nearer(Box{Isometry3d::Identity(), {0.1, 1.0, 0.05}}, box, 0.0));
}

}  // namespace
}  // namespace foothold::collision
