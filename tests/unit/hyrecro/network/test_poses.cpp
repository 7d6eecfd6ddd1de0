// What the networks' inputs mean.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fixtures.hpp"

namespace foothold::hyrecro {
namespace {

using std::numbers::pi;

Isometry3d pose(double x, double y, double z, const Eigen::AngleAxisd& first, const Eigen::AngleAxisd& second) {
  return Isometry3d(Eigen::Translation3d(x, y, z) * first * second);
}
Eigen::AngleAxisd about_y(double angle) { return {angle, Vector3d::UnitY()}; }
Eigen::AngleAxisd about_z(double angle) { return {angle, Vector3d::UnitZ()}; }

// The sixteen poses that the robot cannot tell apart.
std::vector<Isometry3d> equals_of(const Isometry3d& pose) {
  const Eigen::Matrix3d mirror = Vector3d(1.0, -1.0, 1.0).asDiagonal();
  const Isometry3d half_turn(about_z(pi));
  std::vector<Isometry3d> out{pose};
  const auto twice = [&](const auto& change) {
    const std::vector<Isometry3d> before = out;
    for (const Isometry3d& one : before) out.push_back(change(one));
  };
  twice([&](const Isometry3d& p) -> Isometry3d { return p * half_turn; });
  twice([&](const Isometry3d& p) -> Isometry3d { return half_turn * p; });
  twice([&](const Isometry3d& p) -> Isometry3d { return p.inverse(); });
  twice([&](const Isometry3d& p) {
    Isometry3d mirrored = p;
    mirrored.linear() = mirror * p.linear() * mirror;
    mirrored.translation() = mirror * p.translation();
    return mirrored;
  });
  return out;
}

TEST(NetworkPoses, AreOfTheKindThatTheirInverseKinematicsHas) {
  EXPECT_EQ(kind_of(pose(0.2, 0.1, 0.0, about_z(0.3), about_y(0.0))), PoseKind::kFace);
  EXPECT_EQ(kind_of(pose(0.2, 0.1, 0.0, about_z(0.0), about_y(0.0))), PoseKind::kTransition);
  EXPECT_EQ(kind_of(pose(0.2, 0.1, 0.0, about_z(pi), about_y(0.0))), PoseKind::kTransition);
  EXPECT_EQ(kind_of(pose(0.2, 0.1, 0.3, about_y(pi / 2), about_z(pi))), PoseKind::kTransition);
  EXPECT_EQ(kind_of(pose(0.2, 0.1, 0.3, about_y(-2.0), about_z(0.0))), PoseKind::kTransition);
  EXPECT_EQ(kind_of(pose(0.2, 0.1, 0.3, about_z(0.3), about_y(0.0))), std::nullopt);
  EXPECT_EQ(kind_of(pose(0.2, 0.1, 0.0, about_z(0.3), about_y(0.2))), std::nullopt);
  EXPECT_EQ(kind_of(pose(0.2, 0.1, 0.0, about_z(0.3), Eigen::AngleAxisd(pi, Vector3d::UnitX()))), std::nullopt);
}

TEST(NetworkPoses, ThatTheRobotCannotTellApartHaveTheSameInputs) {
  std::mt19937_64 random(1);
  for (const PoseKind kind : {PoseKind::kFace, PoseKind::kTransition})
    for (int i = 0; i < 2000; ++i) {
      const Isometry3d one = random_pose(kind, 0.6, random);
      const NetworkInputs expected = inputs_of(kind, one);
      for (const Isometry3d& equal : equals_of(one)) {
        ASSERT_EQ(kind_of(equal), kind);
        const NetworkInputs inputs = inputs_of(kind, equal);
        for (std::size_t k = 0; k < inputs.size(); ++k)
          ASSERT_NEAR(inputs[k], expected[k], 1e-5) << name_of(kind) << " input " << k;
      }
    }
}

TEST(NetworkPoses, InputsStandForOneOfThePosesThatAreEqual) {
  std::mt19937_64 random(2);
  for (const PoseKind kind : {PoseKind::kFace, PoseKind::kTransition})
    for (int i = 0; i < 2000; ++i) {
      const Isometry3d one = random_pose(kind, 0.6, random);
      const Isometry3d back = pose_of(inputs_of(kind, one));
      double nearest = 1.0;
      for (const Isometry3d& equal : equals_of(one)) nearest = std::min(nearest, (equal.matrix() - back.matrix()).norm());
      ASSERT_LT(nearest, 1e-5) << name_of(kind);
    }
}

TEST(NetworkPoses, OfARightAngleHaveNoLockedAngles) {
  for (const double side : {0.0, pi}) {
    const NetworkInputs inputs = inputs_of(PoseKind::kTransition, pose(0.1, -0.2, 0.3, about_y(pi / 2), about_z(side)));
    EXPECT_FLOAT_EQ(inputs[4], static_cast<float>(pi / 2));
    EXPECT_EQ(inputs[3], 0.0F);
    EXPECT_EQ(inputs[5], 0.0F);
    EXPECT_FLOAT_EQ(inputs[1], 0.2F);
  }
}

TEST(NetworkPoses, AtRandomFillTheBallAndTheDiscEvenly) {
  std::mt19937_64 random(3);
  constexpr int kCount = 40000;
  for (const PoseKind kind : {PoseKind::kFace, PoseKind::kTransition}) {
    int inner = 0, turned_back = 0, antiparallel = 0;
    for (int i = 0; i < kCount; ++i) {
      const Isometry3d one = random_pose(kind, 0.6, random);
      ASSERT_EQ(kind_of(one), kind);
      ASSERT_NEAR((one.linear() * one.linear().transpose() - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-12);
      ASSERT_NEAR(one.linear().determinant(), 1.0, 1e-12);
      ASSERT_LE(one.translation().norm(), 0.6);
      inner += one.translation().norm() < 0.3;
      antiparallel += one(1, 1) < 0.0;
      turned_back += kind == PoseKind::kFace ? one(0, 0) < 0.0 : one(2, 2) < 0.0;
    }
    const double expected = kind == PoseKind::kFace ? 0.25 : 0.125;
    EXPECT_NEAR(inner, expected * kCount, 0.01 * kCount);
    EXPECT_NEAR(turned_back, 0.5 * kCount, 0.015 * kCount);
    EXPECT_NEAR(antiparallel, 0.5 * kCount, 0.015 * kCount);
  }
}

// Postures at random: none of them puts the foot farther than the bound says, and some come near it.
TEST(NetworkPoses, LieWithinTheRadiusThatTheLegsAllow) {
  const Model m = model();
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit;
  double farthest_seen = 0.0;
  for (int i = 0; i < 400000; ++i) {
    Coordinates c;
    for (Leg& leg : c.leg) {
      const auto pick = [&](double& phi, double& y) {
        phi = m.mechanism.greatest_phi() * (2.0 * unit(random) - 1.0);
        const auto range = m.mechanism.offsets(phi);
        y = unit(random) < 0.5 ? range.low : range.high;
      };
      pick(leg.phi1, leg.y1);
      pick(leg.phi2, leg.y2);
    }
    farthest_seen = std::max(farthest_seen, forward(m, c).translation().norm());
  }
  const double bound = farthest(PoseKind::kTransition, m);
  EXPECT_LE(farthest_seen, bound);
  EXPECT_GT(farthest_seen, bound - 0.03);
  EXPECT_LT(farthest(PoseKind::kFace, m), bound);
}

TEST(RobotNumbers, ChangeWithEveryNumberThatReachabilityDependsOn) {
  const Model m = model();
  const std::string numbers = robot_numbers(m);
  Model other = m;
  other.hip_distance += 1e-4;
  EXPECT_NE(robot_numbers(other), numbers);
  other = m;
  other.mechanism = kinematics::PlanarMechanism(0.041, 0.04, 0.19, 0.25);
  EXPECT_NE(robot_numbers(other), numbers);
  other = m;
  other.actuator_speed *= 2.0;
  EXPECT_EQ(robot_numbers(other), numbers);
}

}  // namespace
}  // namespace foothold::hyrecro
