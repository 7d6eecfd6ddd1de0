// A biped from another's URDF walks by the same closed form and passes the same check.
#include <gtest/gtest.h>

#include "another_biped.hpp"
#include "steps.hpp"

namespace foothold::bioloid {
namespace {

Model another() {
  const auto angle = [](double degrees) { return Quantity{{degrees * testing::kDegree}, "rad", "assumed"}; };
  return Model::from_model(RobotModel({{"sole.size", {{0.18, 0.09}, "m", "assumed"}},
                                       {"carrying.shoulder_pitch", angle(0)},
                                       {"carrying.shoulder_roll", angle(-20)},
                                       {"carrying.elbow", angle(-10)}},
                                      {{"urdf", testing::biped_by_hand()}}));
}

TEST(BioloidCheck, AcceptsAnotherBipedsWalk) {
  const Model model = another();
  Posture at = testing::standing(model, 0.455);
  for (int i = 0; i < 4; ++i) {
    const testing::StepOrder order{
        .moving = i % 2 ? Side::kRight : Side::kLeft, .forward = i == 0 || i == 3 ? 0.05 : 0.1, .lift = 0.02, .pelvis = 0.455};
    const Step step = testing::step_after(model, at, order);
    const StepVerdict verdict = check_step(model, {}, step, at, {});
    ASSERT_TRUE(verdict.accepted) << i << ": " << verdict.reason;
    at = step.after;
  }
  EXPECT_NEAR(at.stance[0].frame.translation().x(), 0.15, 1e-12);
  EXPECT_NEAR(at.stance[1].frame.translation().x(), 0.15, 1e-12);
}

}  // namespace
}  // namespace foothold::bioloid
