// Inverse kinematics against the forward chain: closure on all branches, and back to what made the pose.
#include <gtest/gtest.h>

#include <array>

#include "fixtures.hpp"
#include "hyrecro/reach/inverse.hpp"

namespace foothold::hyrecro {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kPoses = 100'000;

double angle_between(double a, double b) { return std::fabs(std::remainder(a - b, 2.0 * kPi)); }

// Greatest difference of two sets of coordinates, angles modulo 2 pi.
double coordinate_difference(const Coordinates& a, const Coordinates& b) {
  double most = 0.0;
  for (std::size_t j = 0; j < 2; ++j)
    for (const double d : {a.leg[j].phi1 - b.leg[j].phi1, a.leg[j].phi2 - b.leg[j].phi2, a.leg[j].y1 - b.leg[j].y1,
                           a.leg[j].y2 - b.leg[j].y2, angle_between(a.hip[j], b.hip[j])})
      most = std::fmax(most, std::fabs(d));
  return most;
}

Free random_free(std::mt19937_64& random) {
  const double m = robot().mechanism.greatest_phi();
  return {uniform(random, -m, m), uniform(random, 0.2, 0.35), uniform(random, 0.0, 1.0), uniform(random, 0.0, 1.0),
          uniform(random, -2.0 * m, 2.0 * m)};
}

struct Counts {
  int solved = 0;
  std::array<int, 4> by_branch{};
};

// All branches of `pose` with `free`: what has a solution closes.
void close_all(const Isometry3d& pose, const Free& free, Counts& counts) {
  for (const int s1 : {1, -1})
    for (const int s2 : {1, -1})
      if (const auto found = inverse(robot(), pose, {s1, s2}, free)) {
        ++counts.solved;
        ++counts.by_branch[static_cast<std::size_t>((s1 < 0 ? 2 : 0) + (s2 < 0 ? 1 : 0))];
        ASSERT_LT(difference(forward(robot(), *found), pose), 1e-9);
        ASSERT_TRUE(within_limits(robot(), *found));
      }
}

TEST(Inverse, RegularPosesCloseOnAllBranches) {
  std::mt19937_64 random(11);
  Counts counts;
  for (int i = 0; i < kPoses; ++i) {
    const Isometry3d pose = forward(robot(), random_coordinates(random));
    ASSERT_FALSE(singular(pose));
    for (int k = 0; k < 4; ++k) close_all(pose, random_free(random), counts);
  }
  for (const int solved : counts.by_branch) EXPECT_GT(solved, 500);
}

TEST(Inverse, SingularPosesCloseOnBothBranches) {
  std::mt19937_64 random(12);
  Counts counts;
  for (int i = 0; i < kPoses; ++i) {
    const Isometry3d pose = forward(robot(), random_singular_coordinates(random));
    ASSERT_TRUE(singular(pose));
    for (int k = 0; k < 4; ++k) close_all(pose, random_free(random), counts);
  }
  for (const int solved : counts.by_branch) EXPECT_GT(solved, 500);
}

TEST(Inverse, GivesBackWhatMadeThePose) {
  std::mt19937_64 random(13);
  for (int i = 0; i < kPoses; ++i) {
    const Coordinates c = i % 2 == 0 ? random_coordinates(random) : random_singular_coordinates(random);
    const Isometry3d pose = forward(robot(), c);
    const auto found = inverse(robot(), pose, branch_of(c), free_of(robot(), c));
    ASSERT_TRUE(found);
    ASSERT_LT(difference(forward(robot(), *found), pose), 1e-9);
    // Near the edge of the branches, where cos(hip0) = 0, and near to singular, coordinates depend on the pose's rounding.
    const double sine = std::fabs(std::sin(c.hip[0] - c.hip[1]));
    if (std::fabs(std::cos(c.hip[0])) < 1e-4 || (i % 2 == 0 && sine < 1e-4)) continue;
    ASSERT_LT(coordinate_difference(*found, c), 1e-8);
  }
}

TEST(Inverse, TheOtherBranchesAreOtherPostures) {
  std::mt19937_64 random(14);
  int pairs = 0;
  for (int i = 0; i < 20000; ++i) {
    const Isometry3d pose = forward(robot(), random_coordinates(random));
    const Free free = random_free(random);
    const auto one = inverse(robot(), pose, {1, 1}, free), two = inverse(robot(), pose, {1, -1}, free);
    if (!one || !two) continue;
    ++pairs;
    EXPECT_GE(std::cos(one->hip[0]), 0.0);
    EXPECT_LE(std::cos(two->hip[0]), 0.0);
    EXPECT_GT(std::sin(one->hip[0] - one->hip[1]), 0.0);
  }
  EXPECT_GT(pairs, 20);
}

TEST(Inverse, HasNoSolutionOutOfReach) {
  std::mt19937_64 random(15);
  Isometry3d far = Isometry3d::Identity();
  far.translation() = Vector3d(1.2, 0.0, 0.0);
  for (int i = 0; i < 10000; ++i)
    for (const int s2 : {1, -1}) EXPECT_FALSE(inverse(robot(), far, {1, s2}, random_free(random)));
}

TEST(Inverse, NearlySingularPosesClose) {
  std::mt19937_64 random(16);
  Counts counts;
  for (int i = 0; i < 20000; ++i) {
    Coordinates c = random_singular_coordinates(random);
    c.hip[1] += std::pow(10.0, uniform(random, -6.9, -3.0));
    const Isometry3d pose = forward(robot(), c);
    const auto found = inverse(robot(), pose, branch_of(c), free_of(robot(), c));
    if (found) {
      ++counts.solved;
      ASSERT_LT(difference(forward(robot(), *found), pose), 1e-9);
    }
  }
  EXPECT_GT(counts.solved, 19000);
}

}  // namespace
}  // namespace foothold::hyrecro
