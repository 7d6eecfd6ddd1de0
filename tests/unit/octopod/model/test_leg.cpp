// A leg's kinematics: forward against turned links, inverse against forward, every branch, the border of the reach.
#include <gtest/gtest.h>

#include "robot.hpp"

namespace foothold::octopod {
namespace {

// The same leg as a chain of turned and shifted frames.
Vector3d foot_by_frames(const Model& model, int which, const Vector3d& q) {
  const double left = side(which);
  Isometry3d at = Isometry3d::Identity();
  at.translate(model.shoulders[static_cast<std::size_t>(which % 4)]);
  at.rotate(Eigen::AngleAxisd(left * (std::numbers::pi / 2 - q[0]), Vector3d::UnitZ()));
  at.translate(Vector3d(model.coxa, 0, 0));
  at.rotate(Eigen::AngleAxisd(-q[1], Vector3d::UnitY()));
  at.translate(Vector3d(model.femur, 0, 0));
  at.rotate(Eigen::AngleAxisd(-q[2], Vector3d::UnitY()));
  at.translate(Vector3d(model.tibia, 0, 0));
  return at.translation();
}

Model with_coxa() {
  Model model = octopod();
  model.coxa = 0.03;
  model.femur = 0.08;
  model.tibia = 0.11;
  return model;
}

TEST(OctopodLeg, TheFootIsWhereTheFramesOfTheLinksEnd) {
  std::mt19937_64 random(1);
  for (const Model& model : {octopod(), with_coxa()})
    for (int i = 0; i < 10000; ++i) {
      const int which = i % kLegs;
      const Vector3d q = random_vector(random, std::numbers::pi);
      EXPECT_LT((leg_in_module(model, which, q).foot - foot_by_frames(model, which, q)).norm(), 1e-14);
    }
}

TEST(OctopodLeg, ARightAngleHasTheFemurLevelAndTheTibiaDown) {
  for (int which = 0; which < kLegs; ++which) {
    const Vector3d& shoulder = octopod().shoulders[static_cast<std::size_t>(which % 4)];
    const LegPoints at = leg_in_module(octopod(), which, {0, 0, -std::numbers::pi / 2});
    EXPECT_LT((at.knee - shoulder - Vector3d(0, side(which) * 0.1, 0)).norm(), 1e-15);
    EXPECT_LT((at.foot - at.knee - Vector3d(0, 0, -0.1)).norm(), 1e-15);
    EXPECT_GT(leg_in_module(octopod(), which, {0.3, 0, -1.5}).foot.x(), at.foot.x());
  }
}

TEST(OctopodLeg, AllBranchesOfTheInverseReachTheFoot) {
  std::mt19937_64 random(2);
  for (const Model& model : {octopod(), with_coxa()}) {
    double worst = 0.0;
    int fours = 0;
    for (int i = 0; i < 100000; ++i) {
      const int which = i % kLegs;
      const Vector3d q = random_vector(random, std::numbers::pi);
      const Vector3d foot = leg_in_module(model, which, q).foot;
      const LegSolutions found = inverse_leg(model, which, foot);
      ASSERT_GE(found.count, 2);
      fours += found.count == 4;
      double nearest = 10.0;
      for (int k = 0; k < found.count; ++k) {
        const Vector3d& joints = found.joints[static_cast<std::size_t>(k)];
        worst = std::max(worst, (leg_in_module(model, which, joints).foot - foot).norm());
        nearest =
            std::min(nearest, (joints - q).unaryExpr([](double a) { return std::remainder(a, 2 * std::numbers::pi); }).norm());
      }
      EXPECT_LT(nearest, 1e-5) << "the posture that the foot was taken from is among the branches";
    }
    EXPECT_LT(worst, 1e-12);
    EXPECT_EQ(fours == 100000, model.coxa == 0.0);
  }
}

TEST(OctopodLeg, TheNaturalBranchIsTheOneWithItsPlaneOutwardsAndTheKneeUp) {
  std::mt19937_64 random(3);
  int reached = 0;
  for (int i = 0; i < 20000; ++i) {
    const int which = i % kLegs;
    const Vector3d foot = octopod().shoulders[static_cast<std::size_t>(which % 4)] + random_vector(random, 0.2);
    const auto natural = natural_leg(octopod(), which, foot);
    const LegSolutions all = inverse_leg(octopod(), which, foot);
    ASSERT_EQ(natural.has_value(), all.count > 0);
    if (!natural) continue;
    ++reached;
    EXPECT_LE(std::abs((*natural)[0]), std::numbers::pi / 2 + 1e-15);
    EXPECT_LE((*natural)[2], 0.0);
    EXPECT_LT((leg_in_module(octopod(), which, *natural).foot - foot).norm(), 1e-12);
  }
  EXPECT_GT(reached, 5000);
}

TEST(OctopodLeg, ReachEndsWhereTheLegIsStretched) {
  const Model& model = octopod();
  const Vector3d direction = Vector3d(0.3, -0.5, -0.7).normalized();
  const Vector3d& shoulder = model.shoulders[1];
  EXPECT_EQ(inverse_leg(model, 5, shoulder + (model.reach() + 1e-9) * direction).count, 0);
  EXPECT_FALSE(natural_leg(model, 5, shoulder + (model.reach() + 1e-9) * direction));
  for (const double short_by : {0.0, 1e-15, 1e-12, 1e-9, 1e-6}) {
    const Vector3d foot = shoulder + (model.reach() - short_by) * direction;
    const auto joints = natural_leg(model, 5, foot);
    ASSERT_TRUE(joints) << short_by;
    EXPECT_LT((leg_in_module(model, 5, *joints).foot - foot).norm(), 2e-12) << short_by;
  }
}

TEST(OctopodLeg, AFootStraightUnderTheShoulderLeavesThePlaneAtTheSide) {
  const auto joints = natural_leg(octopod(), 0, octopod().shoulders[0] - Vector3d(0, 0, 0.15));
  ASSERT_TRUE(joints);
  EXPECT_EQ((*joints)[0], 0.0);
}

TEST(OctopodLeg, TheJacobianIsTheDifferenceQuotient) {
  std::mt19937_64 random(4);
  const Model model = with_coxa();
  for (int i = 0; i < 1000; ++i) {
    const int which = i % kLegs;
    const Vector3d q = random_vector(random, std::numbers::pi);
    const Eigen::Matrix3d jacobian = leg_jacobian(model, which, q);
    for (int k = 0; k < 3; ++k) {
      const Vector3d step = 1e-6 * Vector3d::Unit(k);
      const Vector3d slope = (leg_in_module(model, which, q + step).foot - leg_in_module(model, which, q - step).foot) / 2e-6;
      EXPECT_LT((jacobian.col(k) - slope).norm(), 1e-9);
    }
  }
}

}  // namespace
}  // namespace foothold::octopod
