// One posture: Judge against the figures from their definitions.
#include <gtest/gtest.h>

#include "reference.hpp"

namespace foothold::bioloid {
namespace {

using namespace testing;

// The verdict that the figures give; none where one of them is within rounding of its demand.
std::optional<bool> expected(const Figures& f, const Demands& d, bool both) {
  const double left = room(f, d, both);
  if (std::abs(left) < 1e-9) return {};
  return left > 0.0;
}

TEST(BioloidJudge, AgreesWithExactFiguresOnPosturesOfAWalk) {
  const Model& model = shipped_model();
  Judge judge(model, {});
  Draw draw{std::mt19937_64(1)};
  int good = 0, bad = 0;
  for (int i = 0; i < 8000; ++i) {
    Support support;
    support.foot = i % 2 ? Side::kLeft : Side::kRight;
    const Joints joints = walking(model, support.foot, draw, 0.05 * (i % 11));
    const Figures f = figures(model, joints, support);
    const auto right = expected(f, judge.demands(), false);
    if (!right) continue;
    const Fault fault = judge.posture(joints, support);
    ASSERT_EQ(fault == Fault::kNone, *right) << i << ": fault " << static_cast<int>(fault) << ", self " << f.self << " sole "
                                             << f.sole << " bodies " << f.bodies << " balance " << f.balance;
    (*right ? good : bad) += 1;
    EXPECT_NEAR(judge.balance(joints, support).margin, f.balance, 1e-12);
  }
  EXPECT_GT(good, 800);
  EXPECT_GT(bad, 800);
}

TEST(BioloidJudge, AgreesWithExactDistancesOnAnyPosture) {
  const Model& model = shipped_model();
  Demands demands;
  demands.balance = -1.0;  // so that only bodies and ground count
  demands.ground = 1.0;
  Judge judge(model, demands);
  Draw draw{std::mt19937_64(2)};
  int good = 0, bad = 0;
  for (int i = 0; i < 8000; ++i) {
    Joints joints = model.carrying;
    const int first = i % 4 ? 6 : 0;  // every fourth with arms that move
    for (int j = first; j < static_cast<int>(kJoints); ++j) {
      const auto& limits = model.joints[static_cast<std::size_t>(j)].limits;
      const double part = i % 3 ? 0.3 : 1.0;
      joints[j] = draw(part * limits.low, part * limits.high);
    }
    Support support;
    support.foot = i % 2 ? Side::kLeft : Side::kRight;
    const Figures f = figures(model, joints, support);
    if (std::abs(f.self - demands.clearance) < 1e-9 || std::abs(f.bodies - demands.clearance) < 1e-9) continue;
    const bool right = f.self > demands.clearance && f.bodies > demands.clearance;
    ASSERT_EQ(judge.posture(joints, support) == Fault::kNone, right) << i << ": self " << f.self << " bodies " << f.bodies;
    (right ? good : bad) += 1;
  }
  EXPECT_GT(good, 800);
  EXPECT_GT(bad, 800);
}

}  // namespace
}  // namespace foothold::bioloid
