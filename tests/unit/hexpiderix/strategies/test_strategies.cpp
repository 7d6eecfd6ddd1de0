// The paper's strategies on its own examples, and what they refuse.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "../slopes.hpp"
#include "hexpiderix/strategies/orientation.hpp"

namespace foothold::hexpiderix::testing {
namespace {

TEST(ConstantOrientation, LevelsTheThoraxAndKeepsItsPlaceAndHeading) {
  const Situation from = tilted(20 * kDegree, 70 * kDegree, kTriad2);
  const Adapted to = constant_orientation(shipped_model(), from);
  ASSERT_TRUE(to.stable()) << reason(to.evaluation);
  const Orientation turned = orientation_of(to.evaluation.at.thorax);
  EXPECT_NEAR(turned.roll, 0.0, 1e-12);
  EXPECT_NEAR(turned.pitch, 0.0, 1e-12);
  EXPECT_NEAR(turned.yaw, orientation_of(from.thorax).yaw, 1e-12);
  EXPECT_EQ(to.evaluation.at.thorax.translation(), from.thorax.translation());
}

TEST(Geometric, TurnsByHalfAboutTheAxisOfTheMostLevelLine) {
  // Falling along X, legs 3 and 5 (6 and 2) stand at one height: the Y axis. Falling towards leg 2, legs 1 and 3 do: the X axis.
  const Adapted y = geometric(shipped_model(), tilted(40 * kDegree, 0, kTriad1));
  ASSERT_TRUE(y.evaluation.valid()) << reason(y.evaluation);
  EXPECT_EQ(y.about, "Y axis by 20.0 deg, support line L3-L5");
  EXPECT_NEAR(orientation_of(y.evaluation.at.thorax).pitch, 20 * kDegree, 1e-12);
  EXPECT_EQ(geometric(shipped_model(), tilted(40 * kDegree, 180 * kDegree, kTriad2)).about,
            "Y axis by -20.0 deg, support line L6-L2");
  const Adapted x = geometric(shipped_model(), tilted(20 * kDegree, 60 * kDegree, kTriad1));
  EXPECT_TRUE(x.about.starts_with("X axis by ") && x.about.ends_with("support line L1-L3")) << x.about;
}

TEST(Geometric, AtTwentySixOfFortyFiveDegreesIsThePapersPosture) {
  const Adapted found = geometric(shipped_model(), tilted(45 * kDegree, 0, kTriad1), 26.0 / 45);
  ASSERT_TRUE(found.stable()) << reason(found.evaluation);
  EXPECT_NEAR(found.evaluation.nesm, 2.4e-3, 0.3e-3);
}

TEST(Geometric, NeedsATriad) {
  const Adapted found = geometric(shipped_model(), tilted(10 * kDegree, 0, Legs{0b110100}));
  EXPECT_FALSE(found.evaluation.valid());
  EXPECT_EQ(found.about, "needs the legs of one triad on the ground, and no other");
}

TEST(LegHeight, IsTheFootBelowTheCoxa) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-1.5, 0.0);
  for (int i = 0; i < 100; ++i) {
    const Vector3d joints(angle(random), angle(random), angle(random));
    EXPECT_NEAR(leg_height(shipped_model(), joints), -leg_points(shipped_model(), 2, joints).foot.z(), 1e-15);
  }
}

// Section 4.1.3: on legs 3, 5 and 6 the posture is critical; leg 1 is added and the robot is stable on 30 degrees.
TEST(Emergency, AddsLegOneToLegsThreeFiveAndSixAsThePaperDoes) {
  const Situation level = tilted(0, 0, Legs{0b110100});
  EXPECT_LT(as_it_stands(shipped_model(), level).nesm, 5e-3) << "critical even on level ground";
  const Situation from = tilted(30 * kDegree, 0, Legs{0b110100});
  EXPECT_FALSE(as_it_stands(shipped_model(), from).nesm > 0.0);
  const Adapted found = emergency(shipped_model(), from, EmergencyRule::kLongestDistance);
  EXPECT_EQ(found.about, "leg 1 added");
  EXPECT_TRUE(found.stable()) << reason(found.evaluation) << ", NESM " << found.evaluation.nesm;
}

TEST(Emergency, TheTwelveDistancesAreTheTriadsSidesAndTheHexagons) {
  const std::vector<Distance> all = distances(tilted(0, 0, kTriad1).footholds);
  ASSERT_EQ(all.size(), 12U);
  const double out = shipped_model().thorax_radius + shipped_model().leg.coxa + shipped_model().leg.femur;
  for (std::size_t u = 0; u < 12; ++u) EXPECT_NEAR(all[u].metres, u < 6 ? out * std::sqrt(3.0) : out, 1e-12) << "u" << u + 1;
}

TEST(Emergency, ByBestMarginIsNeverWorseThanByLongestDistance) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> slope(0, 60), direction(0, 360), shift(-0.03, 0.03), turn(-0.2, 0.2);
  int better = 0, both = 0;
  for (int i = 0; i < 10'000; ++i) {
    Legs supports{random() % 64};
    if (supports.count() < 3 || supports.all()) supports = kTriad1;
    Situation from = tilted(slope(random) * kDegree, direction(random) * kDegree, supports);
    from.thorax.translate(Vector3d(shift(random), shift(random), shift(random)));
    from.thorax.rotate(Eigen::AngleAxisd(turn(random), Vector3d::UnitY()));
    const Adapted paper = emergency(shipped_model(), from, EmergencyRule::kLongestDistance);
    const Adapted best = emergency(shipped_model(), from, EmergencyRule::kBestMargin);
    ASSERT_GE(best.evaluation.nesm, paper.evaluation.nesm);
    both += paper.evaluation.valid();
    better += best.evaluation.nesm > paper.evaluation.nesm + 1e-4;
  }
  EXPECT_GT(both, 5'000);
  EXPECT_GT(better, 100);
  std::printf("of 10000 postures the best margin is better on %d, the longest distance stands on %d\n", better, both);
}

TEST(Choice, KeepsWhatIsStableAndElseTakesTheWiderMargin) {
  EXPECT_EQ(chosen(shipped_model(), tilted(5 * kDegree, 0, kTriad1)).strategy, Adapted::Strategy::kNone);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> slope(10, 60), direction(0, 360), shift(-0.04, 0.04);
  std::array<int, 4> taken{};
  for (int i = 0; i < 1'000; ++i) {
    Situation from = tilted(slope(random) * kDegree, direction(random) * kDegree, i % 2 ? kTriad1 : kTriad2);
    from.thorax.translate(
        Vector3d(shift(random), shift(random), 0.0));  // standing upright it tips later than constant orientation ends
    const Adapted found = chosen(shipped_model(), from), level = constant_orientation(shipped_model(), from),
                  half = geometric(shipped_model(), from);
    ++taken[static_cast<std::size_t>(found.strategy)];
    if (as_it_stands(shipped_model(), from).nesm > 0.0) {
      EXPECT_EQ(found.strategy, Adapted::Strategy::kNone);
    } else if (!level.stable() && !half.stable()) {
      EXPECT_EQ(found.strategy, Adapted::Strategy::kEmergency);
    } else {
      for (const Adapted& other : {level, half})
        if (other.stable()) {
          EXPECT_GE(found.evaluation.margin, other.evaluation.margin);
        }
    }
  }
  // A thorax that turns level about its middle hardly moves the centre of mass, so constant orientation mends next to nothing that
  // tips: none of these.
  for (const auto strategy : {Adapted::Strategy::kNone, Adapted::Strategy::kGeometric, Adapted::Strategy::kEmergency})
    EXPECT_GT(taken[static_cast<std::size_t>(strategy)], 0) << name(strategy);
}

}  // namespace
}  // namespace foothold::hexpiderix::testing
