// Thorax and legs: closed both ways for any thorax pose, limits, centre of mass against a chain written apart.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "../slopes.hpp"

namespace foothold::hexpiderix::testing {
namespace {

constexpr double kPi = std::numbers::pi;

Vector3d random_joints(const Model& model, std::mt19937_64& random) {
  Vector3d out;
  for (std::size_t j = 0; j < 3; ++j)
    out[static_cast<int>(j)] = std::uniform_real_distribution<double>(model.limits[j].low, model.limits[j].high)(random);
  return out;
}

Isometry3d random_pose(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(-1, 1);
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = Vector3d(place(random), place(random), place(random));
  pose.linear() =
      (Eigen::AngleAxisd(kPi * place(random), Vector3d::UnitZ()) * Eigen::AngleAxisd(kPi / 2 * place(random), Vector3d::UnitY()) *
       Eigen::AngleAxisd(kPi * place(random), Vector3d::UnitX()))
          .toRotationMatrix();
  return pose;
}

// The links of a leg as rigid motions from the thorax outwards: Denavit and Hartenberg's table of the paper, its femur turned the
// right way round.
std::array<Isometry3d, 4> links(const Model& model, std::size_t leg, const Vector3d& q) {
  using Eigen::AngleAxisd;
  using Eigen::Translation3d;
  const Isometry3d base = AngleAxisd(kPi / 3 * static_cast<double>(leg), Vector3d::UnitZ()) *
                          Translation3d(model.thorax_radius, 0, 0) * Isometry3d::Identity();
  const Isometry3d coxa = base * AngleAxisd(q[0], Vector3d::UnitZ()) * Translation3d(model.leg.coxa, 0, -model.leg.drop);
  const Isometry3d femur = coxa * AngleAxisd(-q[1], Vector3d::UnitY()) * Translation3d(model.leg.femur, 0, 0);
  const Isometry3d tibia = femur * AngleAxisd(-q[2], Vector3d::UnitY()) * Translation3d(model.leg.tibia, 0, 0);
  return {base, coxa, femur, tibia};
}

TEST(HexpiderixBody, AMillionRandomPosturesCloseBothWays) {
  const Model& model = shipped_model();
  std::mt19937_64 random(1);
  constexpr int kCount = 1'000'000;
  double worst = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const Isometry3d thorax = random_pose(random);
    for (std::size_t leg = 0; leg < kLegs; ++leg) {
      const Vector3d joints = random_joints(model, random);
      const Vector3d world = thorax * leg_points(model, leg, joints).foot;
      const auto found = reach(model, leg, thorax.inverse() * world);
      ASSERT_TRUE(found) << "leg " << leg + 1 << ", joints " << joints.transpose();
      ASSERT_TRUE(within_limits(model, *found));
      worst = std::max(worst, (thorax * leg_points(model, leg, *found).foot - world).norm());
    }
  }
  EXPECT_LT(worst, 1e-10);
}

TEST(HexpiderixBody, PointsAndCentreOfMassEqualAChainOfRigidMotions) {
  const Model& model = shipped_model();
  std::mt19937_64 random(2);
  for (int i = 0; i < 2'000; ++i) {
    Joints joints;
    Vector3d moment = Vector3d::Zero();
    double mass = model.thorax_mass;
    for (std::size_t leg = 0; leg < kLegs; ++leg) {
      joints[leg] = random_joints(model, random);
      const auto chain = links(model, leg, joints[leg]);
      const LegPoints points = leg_points(model, leg, joints[leg]);
      ASSERT_LT((points.coxa - chain[0].translation()).norm(), 1e-14);
      ASSERT_LT((points.hip - chain[1].translation()).norm(), 1e-14);
      ASSERT_LT((points.knee - chain[2].translation()).norm(), 1e-14);
      ASSERT_LT((points.foot - chain[3].translation()).norm(), 1e-14);
      for (const int servo : {0, 1, 2}) moment += model.servo_mass * chain[static_cast<std::size_t>(servo)].translation();
      moment += model.femur_mass * (chain[2] * Vector3d(-model.leg.femur / 2, 0, 0));
      moment += model.tibia_mass * (chain[3] * Vector3d(-model.leg.tibia / 2, 0, 0));
      mass += 3 * model.servo_mass + model.femur_mass + model.tibia_mass;
    }
    ASSERT_NEAR(mass, model.mass(), 1e-12);
    ASSERT_LT((centre_of_mass(model, joints) - moment / mass).norm(), 1e-14);
  }
}

TEST(HexpiderixBody, StandsTwelveCentimetresHighAndWeighsWhatTheListOfPartsSays) {
  const Model& model = shipped_model();
  EXPECT_DOUBLE_EQ(model.height(), 0.12);
  EXPECT_NEAR(model.mass(), 1.713, 1e-12);
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    EXPECT_LT((leg_points(model, leg, standing_joints()).foot - standing_foot(model, leg)).norm(), 1e-15);
}

TEST(HexpiderixBody, ASwingingFootHangsRightAboveItsPlace) {
  const Model& model = shipped_model();
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    const Vector3d foot = leg_points(model, leg, swinging_joints(model, leg, model.lift)).foot;
    EXPECT_LT((foot - standing_foot(model, leg) - Vector3d(0, 0, model.lift)).norm(), 1e-12);
  }
}

TEST(HexpiderixBody, AFootOutOfTheLimitsIsNotReached) {
  const Model& model = shipped_model();
  EXPECT_FALSE(reach(model, 0, {model.thorax_radius + 0.236, 0, 0})) << "beyond the stretched leg";
  EXPECT_FALSE(reach(model, 0, leg_points(model, 0, {0.8, 0, -1}).foot)) << "yaw of 46 degrees";
  EXPECT_TRUE(reach(model, 0, leg_points(model, 0, {0.69, 0, -1}).foot));
}

TEST(HexpiderixBody, ThePostureOfTheInterfaceKeepsAllCoordinates) {
  std::mt19937_64 random(3);
  Coordinates at{random_pose(random), {}};
  for (Vector3d& leg : at.legs) leg = random_joints(shipped_model(), random);
  const Coordinates back = from_posture(to_posture(at));
  EXPECT_TRUE(back.thorax.isApprox(at.thorax, 0));
  for (std::size_t leg = 0; leg < kLegs; ++leg) EXPECT_EQ(back.legs[leg], at.legs[leg]);
}

}  // namespace
}  // namespace foothold::hexpiderix::testing
