// Steps that are sound pass, with margins that a dense look at the motion finds too.
#include <gtest/gtest.h>

#include "steps.hpp"

namespace foothold::bioloid {
namespace {

using testing::shipped_model;
using testing::standing;
using testing::step_after;
using testing::StepOrder;

double margin_of(const StepVerdict& verdict, const std::string& name) {
  for (const Margin& margin : verdict.margins)
    if (margin.name == name) return margin.value;
  ADD_FAILURE() << "no margin " << name;
  return -HUGE_VAL;
}

TEST(BioloidCheck, AcceptsAWalkByClosedForm) {
  const Model& model = shipped_model();
  Posture at = standing(model);
  for (int i = 0; i < 4; ++i) {
    const Step step =
        step_after(model, at, {.moving = i % 2 ? Side::kRight : Side::kLeft, .forward = i == 0 || i == 3 ? 0.025 : 0.05});
    const StepVerdict verdict = check_step(model, {}, step, at, {});
    ASSERT_TRUE(verdict.accepted) << i << ": " << verdict.reason;
    EXPECT_GE(margin_of(verdict, "balance"), 0.010);
    EXPECT_GE(margin_of(verdict, "clearance"), 0.002);
    EXPECT_NEAR(margin_of(verdict, "lift"), 0.010, 2e-5);
    EXPECT_GE(margin_of(verdict, "ground"), -2e-4);
    EXPECT_GT(margin_of(verdict, "slip"), 0.0);
    EXPECT_GT(margin_of(verdict, "speed"), 0.0);
    at = step.after;
  }
}

}  // namespace
}  // namespace foothold::bioloid
