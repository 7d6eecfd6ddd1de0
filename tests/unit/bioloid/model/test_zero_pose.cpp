// The zero pose against what is known of the robot, and legs there and back.
#include <gtest/gtest.h>

#include <random>

#include "robot.hpp"

namespace foothold::bioloid {
namespace {

using testing::kDegree;
using testing::shipped_model;

TEST(BioloidModel, WeighsAndBalancesAsPublished) {
  const Model& model = shipped_model();
  EXPECT_NEAR(model.mass(), 1.9144, 1e-9);
  const Isometry3d sole = sole_in_torso(model, Side::kRight, Joints::Zero());
  const Vector3d centre = centre_of_mass(model, Joints::Zero());
  EXPECT_NEAR(centre.z() - sole.translation().z(), 0.198, 0.5e-3);
  EXPECT_NEAR(centre.x() - sole.translation().x(), -0.012, 0.5e-3);
}

TEST(BioloidModel, StandsInTheZeroPoseOnBothSoles) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Isometry3d sole = sole_in_torso(shipped_model(), side, Joints::Zero());
    EXPECT_TRUE(sole.linear().isIdentity(1e-15));
    EXPECT_TRUE(sole.translation().isApprox(Vector3d(0, side == Side::kRight ? -0.0385 : 0.0385, -0.2105), 1e-12));
  }
}

TEST(BioloidModel, CrouchesWithBothSolesFlat) {
  Joints joints = Joints::Zero();
  for (const Side side : {Side::kRight, Side::kLeft}) {
    joints[static_cast<int>(leg_joint(side, 2))] = -45 * kDegree;
    joints[static_cast<int>(leg_joint(side, 3))] = -90 * kDegree;
    joints[static_cast<int>(leg_joint(side, 4))] = 45 * kDegree;
  }
  ASSERT_TRUE(within_limits(shipped_model(), joints));
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Isometry3d sole = sole_in_torso(shipped_model(), side, joints);
    EXPECT_TRUE(sole.linear().isIdentity(1e-12));
    Joints back = joints;
    ASSERT_TRUE(reach(shipped_model(), side, sole, back));
    EXPECT_LT((back - joints).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(BioloidModel, WalkingBranchIsTheInverseOfForward) {
  const Model& model = shipped_model();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 20000; ++i) {
    Joints joints = Joints::Zero();
    for (std::size_t j = 6; j < kJoints; ++j) {
      const auto& limits = model.joints[j].limits;
      joints[static_cast<int>(j)] = limits.low + (limits.high - limits.low) * unit(random);
    }
    for (const Side side : {Side::kRight, Side::kLeft}) {
      Joints back = joints;
      const Isometry3d sole = sole_in_torso(model, side, joints);
      ASSERT_TRUE(reach(model, side, sole, back));
      EXPECT_LT((sole_in_torso(model, side, back).matrix() - sole.matrix()).cwiseAbs().maxCoeff(), 1e-12);
      // The leg's own branch: the knee bent beyond its stretched place, the hip over the ankle's roll axis.
      const Vector3d hip = sole.inverse() * model.hip(side) + model.sole(side);
      if (joints[static_cast<int>(leg_joint(side, 3))] < -22.5 * kDegree && hip.z() > 1e-4) {
        EXPECT_LT((back - joints).cwiseAbs().maxCoeff(), 1e-8) << joints.transpose();
      }
    }
  }
}

}  // namespace
}  // namespace foothold::bioloid
