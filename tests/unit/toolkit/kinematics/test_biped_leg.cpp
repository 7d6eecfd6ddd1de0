// The leg of six joints there and back, on all branches, over all angles and close to where angles are lost.
#include "kinematics/biped_leg.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace foothold::kinematics {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Angles = BipedLeg::Angles;
constexpr double kPi = std::numbers::pi;

// Equal thighs and shins with the knee behind; unequal ones with it in front.
const std::vector<BipedLeg>& legs() {
  static const std::vector<BipedLeg> all{{{-0.0145, 0, -0.075}, {0.0145, 0, -0.075}}, {{0.02, 0, -0.4}, {-0.01, 0, -0.35}}};
  return all;
}

double stretched_knee(const BipedLeg& leg) {
  return std::atan2(leg.thigh.x(), leg.thigh.z()) - std::atan2(leg.shin.x(), leg.shin.z());
}

double off(const Isometry3d& a, const Isometry3d& b) { return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff(); }

double turned(double a, double b) { return std::abs(std::remainder(a - b, 2 * kPi)); }

double apart(const Angles& a, const Angles& b) {
  double most = 0.0;
  for (int k = 0; k < 6; ++k) most = std::max(most, turned(a[k], b[k]));
  return most;
}

void expect_all_reach(const BipedLeg& leg, const Isometry3d& ankle) {
  const auto found = leg.inverse(ankle);
  ASSERT_GE(found.count, 4);
  for (int i = 0; i < found.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_LT(off(leg.forward(found.angles[at]), ankle), 1e-10) << found.angles[at].transpose();
    EXPECT_TRUE(found.angles[at].cwiseAbs().maxCoeff() <= kPi);
    EXPECT_TRUE(i == 0 || found.branch[at - 1] < found.branch[at]);
  }
}

double nearest(const BipedLeg& leg, const Isometry3d& ankle, const Angles& angles) {
  double least = HUGE_VAL;
  const auto found = leg.inverse(ankle);
  for (int i = 0; i < found.count; ++i) least = std::min(least, apart(found.angles[static_cast<std::size_t>(i)], angles));
  return least;
}

TEST(BipedLeg, EverySolutionReachesAndTheOriginalIsOneOfThem) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  for (const BipedLeg& leg : legs())
    for (int i = 0; i < 50000; ++i) {
      Angles angles;
      for (int k = 0; k < 6; ++k) angles[k] = angle(random);
      const Isometry3d ankle = leg.forward(angles);
      expect_all_reach(leg, ankle);
      // Angles are lost near the stretched and folded knee, a roll of 90 deg, and the hip on the ankle's roll axis.
      const double bend = std::abs(std::remainder(angles[3] - stretched_knee(leg), 2 * kPi));
      const Vector3d hip = ankle.linear().transpose() * ankle.translation();
      if (bend > 1e-3 && bend < kPi - 1e-3 && std::abs(std::cos(angles[1])) > 1e-3 && std::hypot(hip.y(), hip.z()) > 1e-3) {
        EXPECT_LT(nearest(leg, ankle, angles), 1e-9) << angles.transpose();
      }
    }
}

TEST(BipedLeg, ReachesCloseToAndOnSingularPoses) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> angle(-kPi, kPi), power(-17.0, -2.0);
  const auto near = [&](double value) {
    const double rest = std::pow(10.0, power(random)) * (angle(random) < 0.0 ? -1.0 : 1.0);
    return angle(random) < -2.5 ? value : value + rest;
  };
  for (const BipedLeg& leg : legs())
    for (int i = 0; i < 30000; ++i) {
      Angles angles;
      for (int k = 0; k < 6; ++k) angles[k] = angle(random);
      if (i % 7 & 1) angles[1] = near(angle(random) < 0.0 ? kPi / 2 : -kPi / 2);
      if (i % 7 & 2) angles[3] = near(stretched_knee(leg) + (angle(random) < 2.0 ? 0.0 : kPi));
      if (i % 7 & 4) {
        // The hip on the ankle's roll axis: seen from there, the shin and what is above lie along X.
        const double c = std::cos(angles[3]), s = std::sin(angles[3]);
        const double x = c * leg.thigh.x() - s * leg.thigh.z() + leg.shin.x(),
                     z = s * leg.thigh.x() + c * leg.thigh.z() + leg.shin.z();
        angles[4] = near(std::atan2(x, z) + (angle(random) < 0.0 ? kPi / 2 : -kPi / 2));
      }
      const Isometry3d ankle = leg.forward(angles);
      const auto found = leg.inverse(ankle);
      ASSERT_GE(found.count, 4) << angles.transpose();
      for (int j = 0; j < found.count; ++j) {
        const Angles& solution = found.angles[static_cast<std::size_t>(j)];
        EXPECT_LT(off(leg.forward(solution), ankle), 1e-10) << angles.transpose() << " by " << solution.transpose();
      }
    }
}

TEST(BipedLeg, NeighbouringPosesHaveNeighbouringAnglesOnTheSameBranch) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> angle(-kPi, kPi), little(-1e-6, 1e-6);
  const BipedLeg& leg = legs()[0];
  int compared = 0;
  for (int i = 0; i < 20000; ++i) {
    Angles angles, beside;
    for (int k = 0; k < 6; ++k) {
      angles[k] = angle(random);
      beside[k] = angles[k] + little(random);
    }
    const double bend = std::abs(std::remainder(angles[3] - stretched_knee(leg), 2 * kPi));
    const Isometry3d ankle = leg.forward(angles);
    const Vector3d hip = ankle.linear().transpose() * ankle.translation();
    if (bend < 0.1 || bend > kPi - 0.1 || std::abs(std::cos(angles[1])) < 0.1 || std::hypot(hip.y(), hip.z()) < 0.02) continue;
    const auto here = leg.inverse(ankle), there = leg.inverse(leg.forward(beside));
    ASSERT_EQ(here.count, 8);
    ASSERT_EQ(there.count, 8);
    for (std::size_t b = 0; b < 8; ++b) {
      EXPECT_EQ(here.branch[b], static_cast<int>(b));
      EXPECT_LT(apart(here.angles[b], there.angles[b]), 2e-3);
      for (std::size_t other = 0; other < b; ++other) EXPECT_GT(apart(here.angles[b], here.angles[other]), 1e-3);
    }
    ++compared;
  }
  EXPECT_GT(compared, 10000);
}

TEST(BipedLeg, StandingIsTheFirstBranch) {
  std::mt19937_64 random(14);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  for (const BipedLeg& leg : legs())
    for (int i = 0; i < 10000; ++i) {
      Angles angles, standing;
      for (int k = 0; k < 6; ++k) angles[k] = angle(random);
      const Isometry3d ankle = leg.forward(angles);
      ASSERT_TRUE(leg.standing(ankle, standing));
      const auto all = leg.inverse(ankle);
      ASSERT_EQ(all.branch[0], 0);
      EXPECT_EQ(apart(standing, all.angles[0]), 0.0);
      EXPECT_LE(std::abs(standing[1]), kPi / 2);
      // The hip over the ankle behind its roll, the knee beyond its stretched place.
      const Vector3d hip = -(ankle.linear().transpose() * ankle.translation());
      EXPECT_GE(std::sin(standing[5]) * hip.y() + std::cos(standing[5]) * hip.z(), -1e-12);
      EXPECT_GE(std::remainder(standing[3] - stretched_knee(leg), 2 * kPi), -1e-12);
    }
}

TEST(BipedLeg, RefusesWhatIsOutOfReach) {
  const BipedLeg& equal = legs()[0];
  const double reach = 2 * std::hypot(0.0145, 0.075);
  Angles angles;
  EXPECT_TRUE(equal.standing(Isometry3d(Eigen::Translation3d(0, 0, -reach)), angles));
  EXPECT_FALSE(equal.standing(Isometry3d(Eigen::Translation3d(0, 0, -reach - 1e-9)), angles));
  EXPECT_EQ(equal.inverse(Isometry3d(Eigen::Translation3d(0, 0.1, -reach))).count, 0);
  EXPECT_EQ(equal.inverse(Isometry3d(Eigen::Translation3d(0, 0, -reach))).count, 4);  // stretched: both bends are one
  const BipedLeg& unequal = legs()[1];
  EXPECT_FALSE(unequal.standing(Isometry3d(Eigen::Translation3d(0, 0, -0.04)), angles));
  Isometry3d nowhere = Isometry3d::Identity();
  nowhere.translation().x() = std::nan("");
  EXPECT_FALSE(equal.standing(nowhere, angles));
}

}  // namespace
}  // namespace foothold::kinematics
