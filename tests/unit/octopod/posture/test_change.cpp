// Half turns, and the difference between postures.
#include <gtest/gtest.h>

#include "independent.hpp"

namespace foothold::octopod {
namespace {

std::vector<Standing> some_standings() {
  const auto ground = bumpy_ground(0.04, 5);
  std::vector<Standing> out;
  for (int t = 0; t < static_cast<int>(ground->terrain.size()); t += 7) {
    const auto i = static_cast<std::size_t>(t);
    const Built built =
        stand(octopod(), ground->surface, ground->terrain.centroids[i], ground->terrain.normals[i], t % kOrientations, 0.0);
    if (built.hindrance == Hindrance::kNone) out.push_back(built.standing);
  }
  return out;
}

TEST(OctopodTurned, TheModulesChangePlacesAndTheFeetStay) {
  for (const Standing& standing : some_standings()) {
    const Standing half = turned(octopod(), {.standing = standing}).standing;
    EXPECT_LT((half.at.front.translation() - standing.rear.translation()).norm(), 1e-14);
    EXPECT_LT((half.rear.translation() - standing.at.front.translation()).norm(), 1e-14);
    EXPECT_LT((half.at.front.linear().col(0) + standing.rear.linear().col(0)).norm(), 1e-14);
    for (int which = 0; which < kLegs; ++which) {
      const LegPoints before = leg(octopod(), standing.at, kLegs - 1 - which), after = leg(octopod(), half.at, which);
      EXPECT_LT((before.shoulder - after.shoulder).norm(), 1e-13);
      EXPECT_LT((before.knee - after.knee).norm(), 1e-13);
      EXPECT_LT((before.foot - after.foot).norm(), 1e-13);
    }
    EXPECT_LT((centre_of_mass(octopod(), half.at) - standing.centre_of_mass).norm(), 1e-13);
    const Standing back = turned(octopod(), {.standing = half}).standing;
    EXPECT_LT(change(back, standing, {}), 1e-7);
  }
}

TEST(OctopodTurned, TheOppositeHeadingIsTheSameRobotTurned) {
  const auto ground = bumpy_ground(0.04, 6);
  const Vector3d node = ground->terrain.centroids[300], normal = ground->terrain.normals[300];
  for (int heading = 0; heading < kAxes; ++heading) {
    const Built one = stand(octopod(), ground->surface, node, normal, heading, 0.0);
    const Built opposite = stand(octopod(), ground->surface, node, normal, heading + kAxes, 0.0);
    ASSERT_EQ(one.hindrance, opposite.hindrance);
    EXPECT_EQ(turned(octopod(), one).standing.at.legs, opposite.standing.at.legs);
    EXPECT_GT(one.standing.at.front.linear().col(0).dot(-opposite.standing.at.front.linear().col(0)), 0.8);
  }
}

TEST(OctopodTurned, ARefusedLegIsTheSameLegOfTheTurnedRobot) {
  EXPECT_EQ(turned(octopod(), {.hindrance = Hindrance::kOutOfReach, .leg = 0, .figure = 0.1}).leg, 7);
  EXPECT_EQ(turned(octopod(), {.hindrance = Hindrance::kCollision, .leg = -1, .figure = 0.1}).leg, -1);
}

TEST(OctopodChange, IsAMetric) {
  const auto all = some_standings();
  ASSERT_GT(all.size(), 30u);
  for (std::size_t i = 0; i < all.size(); i += 2)
    for (std::size_t j = 0; j < all.size(); j += 3) {
      const double ij = change(all[i], all[j], {});
      EXPECT_EQ(ij, change(all[j], all[i], {}));
      EXPECT_EQ(ij == 0.0, i == j);
      for (std::size_t k = 0; k < all.size(); k += 5)
        EXPECT_LE(ij, change(all[i], all[k], {}) + change(all[k], all[j], {}) + 1e-12);
    }
}

TEST(OctopodChange, EveryPartCountsByItsWeight) {
  const auto ground = level_ground();
  const auto at = [&](const Vector3d& node, int heading) {
    return stand(octopod(), ground->surface, node, Vector3d::UnitZ(), heading, 0.0).standing;
  };
  // Both modules move by as much; a shift changes no joint.
  EXPECT_NEAR(change(at({0, 0, 0}, 0), at({0.3, 0.4, 0}, 0), {}), 1.0, 1e-12);
  // Turned on the spot by 45 deg: each module's middle moves along a chord.
  const double chord = 2 * 0.16 * 2 * std::sin(std::numbers::pi / 8), turn = 2 * std::numbers::pi / 4;
  EXPECT_NEAR(change(at({0, 0, 0}, 0), at({0, 0, 0}, 1), {}), chord + 0.1 * turn, 1e-12);
  EXPECT_NEAR(change(at({0, 0, 0}, 7), at({0, 0, 0}, 0), {}), chord + 0.1 * turn, 1e-12) << "round the whole circle, no seam";
  Standing bent = at({0, 0, 0}, 0);
  bent.at.legs[3][0] = 3.0;
  Standing other = bent;
  other.at.legs[3][0] = -3.0;
  EXPECT_NEAR(change(bent, other, {}), 0.01 * (2 * std::numbers::pi - 6.0), 1e-12);
}

}  // namespace
}  // namespace foothold::octopod
