// The three joints that follow from nine free ones.
#include <gtest/gtest.h>

#include "bioloid/posture/nine.hpp"
#include "reference.hpp"

namespace foothold::bioloid {
namespace {

using namespace testing;

TEST(BioloidNine, KeepsTheSwingSoleLevelAndItsHeading) {
  const Model& model = shipped_model();
  Draw draw{std::mt19937_64(3)};
  int coupled = 0;
  for (int i = 0; i < 20000; ++i) {
    const Side support = i % 2 ? Side::kLeft : Side::kRight;
    Nine nine;
    for (int k = 0; k < 9; ++k) {
      const Side side = k < 6 ? support : other(support);
      const auto& limits = model.joints[leg_joint(side, static_cast<std::size_t>(k < 6 ? k : k - 5))].limits;
      nine[k] = draw(0.6 * limits.low, 0.6 * limits.high);
    }
    const double heading = draw(-0.8, 0.8);
    Joints joints;
    if (!couple(model, support, nine, heading, joints)) continue;
    ++coupled;
    EXPECT_EQ(free_joints(joints, support), nine);
    EXPECT_EQ(joints.head<6>(), model.carrying.head<6>());
    const Isometry3d sole = sole_in_torso(model, support, joints).inverse() * sole_in_torso(model, other(support), joints);
    const Eigen::Matrix3d wanted = Eigen::AngleAxisd(heading, Vector3d::UnitZ()).toRotationMatrix();
    EXPECT_LT((sole.linear() - wanted).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_NEAR(heading_of(model, support, joints), heading, 1e-12);
  }
  EXPECT_GT(coupled, 15000);
}

TEST(BioloidNine, GivesBackWhatInverseKinematicsGave) {
  const Model& model = shipped_model();
  Draw draw{std::mt19937_64(4)};
  for (int i = 0; i < 2000; ++i) {
    const Side support = i % 2 ? Side::kLeft : Side::kRight;
    const Joints joints = walking(model, support, draw, 0.0);
    Joints back;
    ASSERT_TRUE(couple(model, support, free_joints(joints, support), heading_of(model, support, joints), back));
    EXPECT_LT((back - joints).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(BioloidNine, SaysSoWhereNoAngleLevelsTheSole) {
  const Model& model = shipped_model();
  // The torso lies back by 90 deg: the swing leg's roll would have to lift the sole's x axis over its plane.
  Nine nine = Nine::Zero();
  nine[2] = -1.6;  // support's hip pitch
  nine[6] = -1.2;  // swing's hip roll
  Joints joints;
  EXPECT_FALSE(couple(model, Side::kRight, nine, 0.0, joints));
}

}  // namespace
}  // namespace foothold::bioloid
