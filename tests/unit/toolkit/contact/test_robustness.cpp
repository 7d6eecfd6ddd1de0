// Margins of equilibrium, against closed forms on level ground and against verdicts round them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "contact/robustness.hpp"
#include "contact/support_polygon.hpp"
#include "stances.hpp"

namespace foothold::contact {
namespace {

std::vector<Contact> level_tripod() {
  return {{{0.2, 0.0, 0.0}, Vector3d::UnitZ()}, {{-0.1, 0.15, 0.0}, Vector3d::UnitZ()}, {{-0.1, -0.1, 0.0}, Vector3d::UnitZ()}};
}

TEST(SupportMargin, OnLevelGroundIsTheDistanceFromTheSupportPolygonsBorder) {
  const std::vector<Contact> feet = level_tripod();
  const std::vector<Vector3d> points = {feet[0].point, feet[1].point, feet[2].point};
  const SupportPolygon polygon = support_polygon(points);
  for (const FrictionCone cone : {FrictionCone::circular(), FrictionCone::pyramid(10)}) {
    Equilibrium equilibrium(cone);
    for (const Vector3d& com : {Vector3d(0.0, 0.0, 0.2), Vector3d(0.05, 0.01, 0.3), Vector3d(-0.08, 0.09, 0.1)}) {
      for (const double mu : {0.05, 0.7}) {
        const Robustness margin = support_margin(equilibrium, feet, com, mu);
        EXPECT_NEAR(margin.value, projected_margin(polygon, com), 2e-6);
        EXPECT_NEAR(margin.direction.norm(), 1.0, 1e-9);
      }
    }
  }
}

TEST(SupportMargin, BesideTheFeetIsNegativeAndNoMoreThanTheWayBack) {
  const std::vector<Contact> feet = level_tripod();
  Equilibrium equilibrium(FrictionCone::circular());
  const Robustness margin = support_margin(equilibrium, feet, {0.3, 0.0, 0.2}, 0.5);
  EXPECT_LT(margin.value, 0.0);
  EXPECT_GE(margin.value, -0.1 - 1e-6);
}

TEST(PushMargin, OnLevelGroundIsFrictionOrTippingWhicheverComesFirst) {
  const std::vector<Contact> feet = level_tripod();
  const std::vector<Vector3d> points = {feet[0].point, feet[1].point, feet[2].point};
  const SupportPolygon polygon = support_polygon(points);
  Equilibrium equilibrium(FrictionCone::circular());
  for (const double height : {0.02, 0.1, 0.4}) {
    for (const double mu : {0.1, 0.3, 0.9}) {
      const Vector3d com(0.0, 0.0, height);
      const double tipping = projected_margin(polygon, com) / height;
      const double margin = push_margin(equilibrium, feet, com, mu).value, exact = std::min(mu, tipping);
      EXPECT_LE(margin, exact + 2e-6) << height << " " << mu;
      EXPECT_GE(margin, exact * (mu < tipping ? 0.999 : 1.0) - 2e-6) << height << " " << mu;  // an arc round 0 if it slides
    }
  }
}

TEST(Robustness, EndsWhereTheVerdictTurns) {
  for (const FrictionCone cone : {FrictionCone::circular(), FrictionCone::pyramid(10)}) {
    std::mt19937_64 random(16);
    Equilibrium equilibrium(cone), judge(cone);
    int finite = 0;
    for (int i = 0; i < 300; ++i) {
      const Stance s = random_stance(random);
      const Robustness margin = support_margin(equilibrium, s.contacts, s.com, s.mu);
      const auto holds = [&](const Vector2d& shift) {
        return judge.judge(s.contacts, s.com + Vector3d(shift.x(), shift.y(), 0.0), s.mu).stable;
      };
      ASSERT_EQ(holds(Vector2d::Zero()), margin.value > 0.0) << i;
      if (!std::isfinite(margin.value)) continue;
      ++finite;
      if (margin.value < 0.0) {  // nowhere nearer is it stable
        for (int k = 0; k < 16; ++k) {
          const double angle = std::numbers::pi * k / 8.0;
          EXPECT_FALSE(holds(-0.999 * margin.value * Vector2d(std::cos(angle), std::sin(angle)))) << i;
        }
        continue;
      }
      for (int k = 0; k < 16; ++k) {
        const double angle = std::numbers::pi * k / 8.0;
        EXPECT_TRUE(holds((margin.value - 3e-6) * Vector2d(std::cos(angle), std::sin(angle)))) << i << " " << margin.value;
      }
      EXPECT_FALSE(holds((margin.value + 3e-6) * margin.direction)) << i << " " << margin.value;
    }
    EXPECT_GT(finite, 200);
  }
}

TEST(Reach, IsAskedOfStableStancesAlone) {
  Equilibrium equilibrium(FrictionCone::circular());
  EXPECT_FALSE(equilibrium.reaches());
  EXPECT_THROW((void)equilibrium.reach(Vector6d::Unit(0)), std::logic_error);
  const std::vector<Contact> feet = level_tripod();
  equilibrium.judge(feet, {0.0, 0.0, 0.2}, 0.5);
  EXPECT_NEAR(equilibrium.reach(Vector6d::Unit(0)).length, 0.5, 1e-9);
  // Heavier is no harder for rigid contacts.
  EXPECT_EQ(equilibrium.reach(Vector6d::Unit(2)).length, std::numeric_limits<double>::infinity());
  EXPECT_NEAR(equilibrium.reach(-Vector6d::Unit(2)).length, 1.0, 1e-9);
}

}  // namespace
}  // namespace foothold::contact
