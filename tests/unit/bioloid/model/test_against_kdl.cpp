// Screws against Orocos KDL over the whole joint space.
#include <gtest/gtest.h>

#include <random>

#include "kdl_robot.hpp"
#include "robot.hpp"

namespace foothold::bioloid {
namespace {

TEST(BioloidAgainstKdl, FramesSolesAndCentreOfMassAgreeOn100000Postures) {
  const Model& model = testing::shipped_model();
  const testing::KdlRobot robot;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double frames_off = 0.0, centre_off = 0.0, soles_off = 0.0;
  for (int i = 0; i < 100000; ++i) {
    Joints joints;
    for (std::size_t j = 0; j < kJoints; ++j) {
      const kinematics::Interval& limits = model.joints[j].limits;
      joints[static_cast<int>(j)] = limits.low + (limits.high - limits.low) * unit(random);
    }
    const auto ours = body_frames(model, joints);
    const auto theirs = robot.state({joints.begin(), joints.end()});
    for (std::size_t b = 0; b < kBodies; ++b)
      frames_off = std::max(frames_off, (ours[b].matrix() - theirs.frames[b].matrix()).cwiseAbs().maxCoeff());
    centre_off = std::max(centre_off, (centre_of_mass(model, joints) - theirs.centre_of_mass).cwiseAbs().maxCoeff());
    for (const Side side : {Side::kRight, Side::kLeft}) {
      const Isometry3d sole = theirs.frames[leg_joint(side, 5) + 1] * Eigen::Translation3d(0, 0, -0.0295);
      soles_off = std::max(soles_off, (sole_in_torso(model, side, joints).matrix() - sole.matrix()).cwiseAbs().maxCoeff());
    }
  }
  EXPECT_LT(frames_off, 1e-10);
  EXPECT_LT(soles_off, 1e-10);
  EXPECT_LT(centre_off, 1e-10);
  EXPECT_NEAR(robot.state(std::vector<double>(kJoints)).mass, model.mass(), 1e-12);
}

// The paper's table 1: the supporting leg as screws from the sole, its lengths L1 = 29.5, L2 = L3 = 75, L4 = 14.5 mm.
TEST(BioloidAgainstKdl, ThePapersTableOfScrewsIsTheSupportLegBackwards) {
  const Model& model = testing::shipped_model();
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> angle(-1.0, 1.0);
  const double l1 = 0.0295, l2 = 0.075, l3 = 0.075, l4 = 0.0145;
  using kinematics::Screw;
  const Vector3d x = Vector3d::UnitX(), y = -Vector3d::UnitY(), z = Vector3d::UnitZ();
  // From the sole up: ankle roll, ankle pitch, knee, hip pitch, roll, yaw. The table has the two of the ankle the other way round
  // and the hip's yaw through the sole's centre, which is the same line.
  const std::array<Screw, 6> screws{Screw{x, {0, 0, l1}},           Screw{y, {0, 0, l1}},           Screw{y, {-l4, 0, l1 + l2}},
                                    Screw{y, {0, 0, l1 + l2 + l3}}, Screw{x, {0, 0, l1 + l2 + l3}}, Screw{z, {0, 0, 0}}};
  for (int i = 0; i < 1000; ++i) {
    Joints joints = Joints::Zero();
    std::array<double, 6> up{};
    for (std::size_t k = 0; k < kLegJoints; ++k) {
      const double servo = angle(random);
      joints[static_cast<int>(leg_joint(Side::kRight, k))] = servo;
      // What turns the foot against the leg turns the leg the other way about the same line; the hip's pitch counts about +Y.
      up[kLegJoints - 1 - k] = k == 2 ? servo : -servo;
    }
    const Isometry3d hip_zero = Isometry3d(Eigen::Translation3d(0, 0, l1 + l2 + l3));
    const Isometry3d torso_at_hip = Isometry3d(Eigen::Translation3d(-model.hip(Side::kRight)));
    const Isometry3d torso = kinematics::closure(screws, up) * hip_zero * torso_at_hip;
    EXPECT_LT((torso.inverse().matrix() - sole_in_torso(model, Side::kRight, joints).matrix()).cwiseAbs().maxCoeff(), 1e-12);
  }
}

}  // namespace
}  // namespace foothold::bioloid
