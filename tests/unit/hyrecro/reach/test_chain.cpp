// The chain: seen from either foot, as joints and back, and frames that belong together.
#include <gtest/gtest.h>

#include "fixtures.hpp"

namespace foothold::hyrecro {
namespace {

constexpr double kPi = std::numbers::pi;

Isometry3d rotation(double angle, const Vector3d& axis) { return Isometry3d(Eigen::AngleAxisd(angle, axis)); }
Isometry3d translation(const Vector3d& by) { return Isometry3d(Eigen::Translation3d(by)); }

// The chain as the paper writes it, in the paper's frames throughout.
Isometry3d paper_chain(const Model& m, const Coordinates& c) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const auto leg = [&](const Leg& l) {
    return translation(m.ankle_height * y) * rotation(l.phi1, z) * translation((l.y1 + l.y2 - m.core) * y) * rotation(l.phi2, z) *
           translation(m.hip_drop * y);
  };
  return leg(c.leg[0]) * rotation(c.hip[0], y) * translation(m.hip_distance * x) * rotation(-c.hip[1], y) * leg(c.leg[1]).inverse();
}

TEST(Chain, IsThePapersInTheInterfacesFrames) {
  std::mt19937_64 random(21);
  const Isometry3d to_wire = rotation(0.5 * kPi, Vector3d::UnitX());  // Y becomes Z, Z becomes -Y
  for (int i = 0; i < 5000; ++i) {
    const Coordinates c = random_coordinates(random);
    EXPECT_LT(difference(forward(robot(), c), to_wire * paper_chain(robot(), c) * to_wire.inverse()), 1e-12);
  }
}

TEST(Chain, SwappedIsTheSamePostureFromTheOtherFoot) {
  std::mt19937_64 random(22);
  for (int i = 0; i < 5000; ++i) {
    const Coordinates c = random_coordinates(random), s = swapped(c);
    EXPECT_LT(difference(forward(robot(), c) * forward(robot(), s), Isometry3d::Identity()), 1e-12);
    const Frames one = frames(robot(), c), two = frames(robot(), s);
    for (std::size_t j = 0; j < 2; ++j) {
      EXPECT_LT((one.sole[1] * two.ankle_pin[1 - j] - one.ankle_pin[j]).norm(), 1e-12);
      EXPECT_LT((one.sole[1] * two.upper_pin[1 - j] - one.upper_pin[j]).norm(), 1e-12);
    }
    // The hip plate is the same body; its X points from the foot that one looks from.
    EXPECT_LT(difference(one.sole[1] * two.hip, one.hip * rotation(kPi, Vector3d::UnitZ())), 1e-12);
    EXPECT_LT(difference(forward(robot(), swapped(s)), forward(robot(), c)), 1e-12);
  }
}

TEST(Chain, JointsAndCoordinatesAreInverse) {
  std::mt19937_64 random(23);
  for (int i = 0; i < 5000; ++i) {
    const Coordinates c = random_coordinates(random);
    EXPECT_TRUE(within_limits(robot(), c));
    for (const Foot first : {Foot::kA, Foot::kB}) {
      const std::vector<double> joints = to_joints(robot(), c, first);
      ASSERT_EQ(joints.size(), kJoints);
      const Coordinates again = from_joints(robot(), joints, first);
      EXPECT_LT(difference(forward(robot(), again), forward(robot(), c)), 1e-12);
      for (std::size_t j = 0; j < 2; ++j) EXPECT_NEAR(leg_length(robot(), again.leg[j]), leg_length(robot(), c.leg[j]), 1e-13);
    }
    // The joints name the feet, so they are the same from wherever one looks.
    const std::vector<double> a = to_joints(robot(), c, Foot::kA), b = to_joints(robot(), swapped(c), Foot::kB);
    for (std::size_t k = 0; k < kJoints; ++k) EXPECT_NEAR(std::remainder(a[k] - b[k], 2.0 * kPi), 0.0, 1e-12);
  }
}

TEST(Chain, LimitsAreThoseOfEachActuator) {
  std::mt19937_64 random(24);
  for (int i = 0; i < 2000; ++i) {
    Coordinates c = random_coordinates(random);
    std::vector<double> joints = to_joints(robot(), c, Foot::kA);
    const std::size_t which = random() % 8;
    joints[which] = random() % 2 == 0 ? robot().mechanism.longest() + 1e-5 : robot().mechanism.shortest() - 1e-5;
    EXPECT_FALSE(within_limits(robot(), from_joints(robot(), joints, Foot::kA)));
    EXPECT_TRUE(within_limits(robot(), from_joints(robot(), joints, Foot::kA), 2e-5));
  }
}

}  // namespace
}  // namespace foothold::hyrecro
