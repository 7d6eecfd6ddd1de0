// The leg with a yaw and two pitches: closed both ways, all branches, and what lies out of reach.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "kinematics/yaw_leg.hpp"

namespace foothold::kinematics {
namespace {

using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;
constexpr YawLeg kLeg{.coxa = 0.03, .drop = 0.01, .femur = 0.085, .tibia = 0.12};

Vector3d random_joints(std::mt19937_64& random) {
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  return {angle(random), angle(random), angle(random)};
}

double angle_between(double a, double b) { return std::abs(std::remainder(a - b, 2.0 * kPi)); }

// By a chain of rigid motions, written apart from the closed form.
Vector3d foot_by_transforms(const YawLeg& leg, const Vector3d& joints) {
  using Eigen::AngleAxisd;
  using Eigen::Translation3d;
  const Eigen::Isometry3d chain = AngleAxisd(joints[0], Vector3d::UnitZ()) * Translation3d(leg.coxa, 0, -leg.drop) *
                                  AngleAxisd(-joints[1], Vector3d::UnitY()) * Translation3d(leg.femur, 0, 0) *
                                  AngleAxisd(-joints[2], Vector3d::UnitY()) * Translation3d(leg.tibia, 0, 0);
  return chain.translation();
}

TEST(YawLeg, ForwardEqualsAChainOfRigidMotions) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 10'000; ++i) {
    const Vector3d joints = random_joints(random);
    ASSERT_LT((kLeg.forward(joints).foot - foot_by_transforms(kLeg, joints)).norm(), 1e-14);
  }
}

TEST(YawLeg, EveryBranchLeadsBackToTheFootAndOneIsWhereItCameFrom) {
  std::mt19937_64 random(2);
  for (const YawLeg& leg : {kLeg, YawLeg{.coxa = 0, .drop = 0, .femur = 0.1, .tibia = 0.1}}) {
    for (int i = 0; i < 100'000; ++i) {
      const Vector3d joints = random_joints(random);
      const Vector3d foot = leg.forward(joints).foot;
      bool found = false;
      const YawLeg::Solutions solutions = leg.inverse(foot);
      for (const Vector3d& solution : solutions) {
        ASSERT_LT((leg.forward(solution).foot - foot).norm(), 1e-12);
        double off = 0.0;
        for (int j = 0; j < 3; ++j) off = std::max(off, angle_between(solution[j], joints[j]));
        found = found || off < 1e-5;
      }
      ASSERT_TRUE(found) << joints.transpose();
    }
  }
}

TEST(YawLeg, TheStandingSolutionIsTheBranchWithinAQuarterTurnAndTheKneeUp) {
  std::mt19937_64 random(3);
  for (const YawLeg& leg : {kLeg, YawLeg{.coxa = 0, .drop = 0, .femur = 0.1, .tibia = 0.1}}) {
    int reached = 0;
    for (int i = 0; i < 20'000; ++i) {
      std::uniform_real_distribution<double> within(-0.25, 0.25);
      const Vector3d foot(within(random), within(random), within(random));
      int branch = 0;
      for (const Vector3d& solution : leg.inverse(foot)) {
        if (std::abs(solution[0]) > kPi / 2 || solution[2] > 0.0) continue;
        ++branch;
        ASSERT_TRUE(leg.standing(foot)) << foot.transpose();
        EXPECT_LT((*leg.standing(foot) - solution).norm(), 1e-12);
      }
      ASSERT_EQ(branch > 0, leg.standing(foot).has_value());
      reached += branch > 0;
    }
    EXPECT_GT(reached, 2'000);
  }
}

TEST(YawLeg, KeepsItsDigitsWhereTheLegIsStretchedOrFolded) {
  const YawLeg leg{.coxa = 0, .drop = 0, .femur = 0.1, .tibia = 0.1};
  const Vector3d along = Vector3d(0.4, -0.3, -0.8).normalized();
  for (const double distance : {0.2, 0.2 - 1e-15, 0.2 - 1e-12, 0.2 - 1e-8, 1e-3, 1e-6, 1e-9}) {
    const auto joints = leg.standing(distance * along);
    ASSERT_TRUE(joints) << distance;
    EXPECT_LT((leg.forward(*joints).foot - distance * along).norm(), 1e-16 + 1e-15 * distance) << distance;
  }
}

TEST(YawLeg, ASweepOverTheJointsFindsNoFootThatTheInverseMisses) {
  int reached = 0;
  for (double femur = -kPi; femur < kPi; femur += 0.05) {
    for (double tibia = -kPi; tibia < kPi; tibia += 0.05) {
      const Vector3d foot = kLeg.forward({0.7, femur, tibia}).foot;
      ASSERT_GT(kLeg.inverse(foot).count, 0);
      ++reached;
    }
  }
  EXPECT_GT(reached, 10'000);
}

TEST(YawLeg, OutOfReachHasNoSolution) {
  EXPECT_EQ(kLeg.inverse({0.03 + 0.085 + 0.12 + 1e-9, 0, -0.01}).count, 0);
  EXPECT_EQ(kLeg.inverse({0.03, 0, -0.01}).count, 2) << "in front it is too near to fold; behind it is in reach";
}

TEST(YawLeg, OnTheAxisTheYawIsTheCallers) {
  const YawLeg leg{.coxa = 0, .drop = 0, .femur = 0.1, .tibia = 0.1};
  for (const Vector3d& joints : leg.inverse({0, 0, -0.15}, 0.4)) {
    EXPECT_TRUE(angle_between(joints[0], 0.4) < 1e-12 || angle_between(joints[0], 0.4 + kPi) < 1e-12);
    EXPECT_LT((leg.forward(joints).foot - Vector3d(0, 0, -0.15)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace foothold::kinematics
