// Bodies where the chain puts them, and of the robot with itself every pair that counts.
#include <gtest/gtest.h>

#include <numbers>

#include "random_scenes.hpp"

namespace foothold::hyrecro {
namespace {

const std::vector<double> kUpright{0.22, 0.22, 0.22, 0.22, 0.22, 0.22, 0.22, 0.22, 0.0, 0.0};

// Mid stroke: both legs straight up, side by side, the hip plate 0.36 m above both soles.
TEST(BodiesAt, MidStrokeStandLikeAnArch) {
  const Model model = shipped_model();
  const Bodies bodies = bodies_at(model, from_joints(model, kUpright, Foot::kA), Isometry3d::Identity());
  const double leg = 2.0 * 0.22 - model.core;
  const Vector3d hip(0.5 * model.hip_distance, 0.0, model.ankle_height + leg + model.hip_drop);
  EXPECT_LT((bodies.hip.pose.translation() - hip).norm(), 1e-12);
  EXPECT_LT((2.0 * bodies.hip.half - model.hip_plate).norm(), 1e-12);
  for (std::size_t j = 0; j < 2; ++j) {
    const double x = j == 0 ? 0.0 : model.hip_distance;
    EXPECT_LT((bodies.leg[j].a - Vector3d(x, 0.0, model.ankle_height + model.leg_begin)).norm(), 1e-12);
    EXPECT_LT((bodies.leg[j].b - Vector3d(x, 0.0, model.ankle_height + leg)).norm(), 1e-12);
    const double top = bodies.plate[j].pose.translation().z() + bodies.plate[j].half.z();
    const double bottom = bodies.plate[j].pose.translation().z() - bodies.plate[j].half.z();
    EXPECT_NEAR(top, model.plate.z(), 1e-12);
    EXPECT_NEAR(bottom, model.skin, 1e-12);
  }
  // Nearest to each other are the plates, 0.156 - 0.1 m; the legs' sides are 0.076 m apart.
  EXPECT_NEAR(self_distance(bodies), model.hip_distance - model.plate.x(), 1e-12);
  EXPECT_TRUE(free_of_itself(bodies, 0.055));
  EXPECT_FALSE(free_of_itself(bodies, 0.057));
}

TEST(BodiesAt, TheSamePostureSeenFromTheOtherFootAreTheSameBodies) {
  const Model model = shipped_model();
  Chance chance(11);
  for (int k = 0; k < 300; ++k) {
    const Coordinates c = chance.coordinates(model);
    const Isometry3d sole = chance.pose(1.0);
    const Bodies a = bodies_at(model, c, sole), b = bodies_at(model, swapped(c), sole * forward(model, c));
    for (std::size_t j = 0; j < 2; ++j) {
      EXPECT_TRUE(a.plate[j].pose.isApprox(b.plate[1 - j].pose, 1e-12));
      EXPECT_LT((a.leg[j].a - b.leg[1 - j].a).norm() + (a.leg[j].b - b.leg[1 - j].b).norm(), 1e-12);
    }
    EXPECT_LT((a.hip.pose.translation() - b.hip.pose.translation()).norm(), 1e-12);
    EXPECT_NEAR(self_distance(a), self_distance(b), 1e-9);
  }
}

TEST(FreeOfItself, AgreesWithTheDistance) {
  const Model model = shipped_model();
  Chance chance(12);
  int free = 0;
  for (int k = 0; k < 3000; ++k) {
    const Bodies bodies = bodies_at(model, chance.coordinates(model), chance.pose(1.0));
    const double is = self_distance(bodies);
    for (const double clearance : {0.005, 0.02, 0.1})
      if (std::abs(is - clearance) > 1e-9) {
        EXPECT_EQ(free_of_itself(bodies, clearance), is >= clearance);
      }
    free += is > 0.005;
  }
  EXPECT_GT(free, 300);
  EXPECT_LT(free, 2900);
}

}  // namespace
}  // namespace foothold::hyrecro
