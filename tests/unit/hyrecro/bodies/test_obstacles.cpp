// Obstacles behind their tree against every body with every solid.
#include <gtest/gtest.h>

#include <limits>

#include "random_scenes.hpp"

namespace foothold::hyrecro {
namespace {

using collision::Box;
using collision::Capsule;
using collision::Patch;

template <class Body>
double by_hand(const Body& body, const truss::Solid& solid) {
  if (solid.kind == truss::Solid::Kind::kBox) return collision::distance(body, Box{solid.pose, solid.half});
  std::vector<Vector3d> vertices;
  for (const auto& v : solid.polygon) vertices.push_back(solid.pose * Vector3d(v.x(), v.y(), 0.0));
  return collision::distance(body, Patch{vertices});
}

template <class Body>
double by_hand(const Body& body, const truss::Truss& truss) {
  double least = std::numeric_limits<double>::infinity();
  for (const truss::Solid& solid : truss.solids) least = std::min(least, by_hand(body, solid));
  return least;
}

class ObstaclesOf : public testing::TestWithParam<int> {
 protected:
  const Model model_ = shipped_model();
};

TEST_P(ObstaclesOf, AgreeWithEveryPairOfBodies) {
  Chance chance(static_cast<unsigned>(GetParam()));
  const double extent = 0.3 + 0.25 * std::cbrt(GetParam());
  int free = 0;
  const int kScenes = GetParam() > 100 ? 2 : 20, kPostures = 100;
  for (int scene = 0; scene < kScenes; ++scene) {
    const truss::Truss truss = chance.scene(GetParam(), extent);
    const Obstacles obstacles(truss);
    for (int k = 0; k < kPostures; ++k) {
      const Bodies bodies = bodies_at(model_, chance.coordinates(model_), chance.pose(extent));
      const double legs = std::min(by_hand(bodies.leg[0], truss), by_hand(bodies.leg[1], truss)), hip = by_hand(bodies.hip, truss);
      const double plates = std::min(by_hand(bodies.plate[0], truss), by_hand(bodies.plate[1], truss));
      for (const double clearance : {0.0, 0.005, 0.05})
        EXPECT_EQ(obstacles.free(bodies, clearance), std::min(legs, hip) > 0.0 && std::min(legs, hip) >= clearance && plates > 0.0);
      free += std::min({legs, hip, plates}) > 0.0;
      for (const double reach : {0.01, 0.2, 10.0}) {
        const auto nearest = obstacles.nearest(bodies, reach), of_plates = obstacles.nearest_of_plates(bodies, reach);
        const double infinite = std::numeric_limits<double>::infinity();
        EXPECT_EQ(nearest.distance, std::min(legs, hip) <= reach ? std::min(legs, hip) : infinite);
        EXPECT_EQ(of_plates.distance, plates <= reach ? plates : infinite);
        EXPECT_EQ(obstacles.distance(bodies.hip, reach), hip <= reach ? hip : infinite);
        const double leg = by_hand(bodies.leg[1], truss);
        EXPECT_EQ(obstacles.distance(bodies.leg[1], reach), leg <= reach ? leg : infinite);
      }
    }
  }
  if (GetParam() > 1) {
    EXPECT_GT(free, kScenes * kPostures / 50);
    EXPECT_LT(free, kScenes * kPostures);
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, ObstaclesOf, testing::Values(0, 1, 2, 5, 40, 1000));

TEST(Obstacles, NameTheBodyAndTheSolidThatAreNearest) {
  const Model model = shipped_model();
  truss::Truss truss;
  truss.solids.resize(3);
  for (std::size_t k = 0; k < 3; ++k) truss.solids[k].half = {0.05, 0.05, 0.05};
  const std::vector<double> middle{0.22, 0.22, 0.22, 0.22, 0.22, 0.22, 0.22, 0.22, 0.0, 0.0};
  const Bodies bodies = bodies_at(model, from_joints(model, middle, Foot::kA), Isometry3d::Identity());
  truss.solids[0].pose.translation() = bodies.hip.pose.translation() + Vector3d(0.0, 0.0, 0.08);
  truss.solids[1].pose.translation() = bodies.leg[1].a + Vector3d(0.14, 0.0, 0.05);
  truss.solids[2].pose.translation() = bodies.plate[0].pose.translation() - Vector3d(0.0, 0.0, 0.08);
  const Obstacles obstacles(truss);
  const auto nearest = obstacles.nearest(bodies, 1.0);
  EXPECT_EQ(nearest.body, "hip");
  EXPECT_EQ(nearest.solid, 0);
  EXPECT_NEAR(nearest.distance, 0.025, 1e-12);
  const auto of_plates = obstacles.nearest_of_plates(bodies, 1.0);
  EXPECT_EQ(of_plates.body, "plate 0");
  EXPECT_EQ(of_plates.solid, 2);
  EXPECT_NEAR(of_plates.distance, 0.08 - 0.05 - 0.0045, 1e-12);
}

}  // namespace
}  // namespace foothold::hyrecro
