// The judge's kinematics are those of the planner, though written apart.
#include <gtest/gtest.h>

#include "octopod/check/skeleton.hpp"
#include "robot.hpp"

namespace foothold::octopod {
namespace {

TEST(Skeleton, IsThePlannersRobot) {
  std::mt19937_64 random(1);
  for (int run = 0; run < 2000; ++run) {
    const Coordinates at = random_coordinates(random);
    const Posture posture = to_posture(at);
    const Skeleton seen = skeleton(octopod(), posture.base, posture.joints);
    EXPECT_TRUE(seen.module[0].isApprox(at.front, 1e-12));
    EXPECT_LT((seen.module[1].matrix() - rear(octopod(), at).matrix()).norm(), 1e-9);
    EXPECT_LT((seen.joint - centre(octopod(), at)).norm(), 1e-12);
    EXPECT_LT((seen.centre_of_mass - centre_of_mass(octopod(), at)).norm(), 1e-9);
    for (int k = 0; k < kLegs; ++k) {
      const LegPoints points = leg(octopod(), at, k);
      const Skeleton::Limb& limb = seen.limbs[static_cast<std::size_t>(k)];
      EXPECT_LT((limb.hip - points.shoulder).norm(), 1e-9) << k;
      EXPECT_LT((limb.knee - points.knee).norm(), 1e-9) << k;
      EXPECT_LT((limb.foot - points.foot).norm(), 1e-9) << k;
      EXPECT_NEAR((limb.ankle - limb.foot).norm(), octopod().foot, 1e-12);
    }
  }
}

TEST(Skeleton, HangsOnAClosedTree) {
  std::mt19937_64 random(2);
  for (int run = 0; run < 200; ++run) {
    const Posture posture = to_posture(random_coordinates(random));
    const Skeleton seen = skeleton(octopod(), posture.base, posture.joints);
    const Vector3d from_a = seen.module[0] * Vector3d(-octopod().arm(), 0.0, 0.0);
    const Vector3d from_b = seen.module[1] * Vector3d(octopod().arm(), 0.0, 0.0);
    EXPECT_LT((from_a - seen.joint).norm(), 1e-12);
    EXPECT_LT((from_b - seen.joint).norm(), 1e-12);
    for (const Skeleton::Limb& limb : seen.limbs) {
      EXPECT_NEAR((limb.knee - limb.hip).norm(), octopod().femur, 1e-12);
      EXPECT_NEAR((limb.foot - limb.knee).norm(), octopod().tibia, 1e-12);
    }
  }
}

}  // namespace
}  // namespace foothold::octopod
