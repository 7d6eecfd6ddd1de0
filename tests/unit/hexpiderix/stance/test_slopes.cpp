// The paper's slopes: NESM of a tripod whose thorax turns back against the slope, and the slope at which a level thorax is too
// much.
#include <gtest/gtest.h>

#include <cmath>

#include "../slopes.hpp"

namespace foothold::hexpiderix::testing {
namespace {

// Triad 1 on a slope that falls towards leg 1; the thorax turned by `reorientation` about its own middle, back towards the level.
Evaluation on_slope(double slope, double reorientation, const Swing& swing) {
  Situation at = tilted(slope, 0.0, kTriad1);
  at.thorax.rotate(Eigen::AngleAxisd(-reorientation, Vector3d::UnitY()));
  return evaluate(shipped_model(), at.ground, at.footholds, at.thorax, swing, at.clearance);
}

struct Row {
  double slope, reorientation, nesm;  // deg, deg, mm
};
constexpr Row kTable[] = {{15, 15, 20}, {30, 30, 10.3}, {45, 26, 2.4}, {50, 32, 1.0}, {55, 33, 0.1}, {60, 34, -0.1}};

TEST(HexpiderixSlopes, TheTableOfStabilitiesComesOutWithItsSigns) {
  for (const Row& row : kTable) {
    const Evaluation found = on_slope(row.slope * kDegree, row.reorientation * kDegree, {shipped_model().lift, true});
    ASSERT_TRUE(found.valid()) << row.slope << " deg: " << reason(found);
    EXPECT_NEAR(1e3 * found.nesm, row.nesm, 0.3) << row.slope << " deg";
    EXPECT_EQ(found.nesm > 0.0, row.nesm > 0.0) << row.slope << " deg: " << 1e3 * found.nesm;
    std::printf("%2.0f deg, turned back %2.0f deg: NESM %6.2f mm (paper's table %5.1f), needs friction %.2f\n", row.slope,
                row.reorientation, 1e3 * found.nesm, row.nesm, std::tan(row.slope * kDegree));
  }
}

// The paper: not above 30 degrees, since leg 4 meets the ground.
TEST(HexpiderixSlopes, ALevelThoraxIsRefusedWhereLegFourMeetsTheGround) {
  double last = -1.0;
  for (double slope = 0.0; slope < 34.0; slope += 0.05) {
    const Evaluation found = on_slope(slope * kDegree, slope * kDegree, {shipped_model().lift, false});
    if (found.valid()) {
      EXPECT_LT(last, slope) << "valid again above " << last;
      last = slope;
      continue;
    }
    EXPECT_EQ(found.fault, Evaluation::Fault::kLegOnGround);
    EXPECT_EQ(found.leg, 3U) << reason(found);
    if (found.leg != 3U) break;
  }
  EXPECT_GE(last, 30.0);
  EXPECT_LT(last, 30.5);
  // In closed form: leg 4's lifted foot on the ground.
  const Model& m = shipped_model();
  const double out = m.thorax_radius + m.leg.coxa + m.leg.femur, down = m.height() - m.lift, slope = (last + 0.05) * kDegree;
  EXPECT_LT(m.height() - out * std::sin(slope) - down * std::cos(slope), 0.0);
}

TEST(HexpiderixSlopes, TheStandingRobotKeepsItsJointsOnEverySlope) {
  for (const double slope : {0.0, 20.0, 40.0, 60.0})
    for (const double direction : {0.0, 33.0, 190.0})
      for (const double heading : {0.0, 77.0}) {
        const Plane plane = tilted_plane(slope * kDegree, direction * kDegree);
        const Footholds feet = standing_footholds(shipped_model(), plane, {1, 2, 3}, heading * kDegree, kTriad2);
        const Evaluation found =
            evaluate(shipped_model(), plane, feet, standing_thorax(shipped_model(), plane, {1, 2, 3}, heading * kDegree),
                     {shipped_model().lift, false}, 0.0);
        ASSERT_TRUE(found.valid()) << reason(found);
        for (const std::size_t leg : {1U, 3U, 5U}) {
          EXPECT_LT((found.at.legs[leg] - standing_joints()).norm(), 1e-9);
          EXPECT_NEAR(plane.above(feet.points[leg]), 0.0, 1e-12);
        }
      }
}

}  // namespace
}  // namespace foothold::hexpiderix::testing
