// Legs and bodies against each other: by many points, on random robots, on standing ones, and on ones that are set up to touch.
#include <gtest/gtest.h>

#include "crossing.hpp"
#include "terrain/generate.hpp"

namespace foothold::octopod {
namespace {

// Between the surfaces of both bodies, by a grid of points on each.
double between_bodies(const std::array<Isometry3d, 2>& poses) {
  const Vector3d half = octopod().body / 2;
  double least = INFINITY;
  for (const std::size_t m : {0U, 1U})
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; j <= 20; ++j)
        for (int k = 0; k <= 20; ++k) {
          const Vector3d seen =
              poses[1 - m].inverse() * (poses[m] * octopod().body.cwiseProduct(Vector3d(i, j, k) / 20 - Vector3d::Constant(0.5)));
          least = std::min(least, (seen - seen.cwiseMin(half).cwiseMax(-half)).norm());
        }
  return least;
}

TEST(OctopodApart, RandomRobotsAsByManyPoints) {
  std::mt19937_64 random(11);
  int apart = 0, touching = 0;
  for (int k = 0; k < 400; ++k) {
    Coordinates at = random_coordinates(random);
    at.ball = Eigen::Quaterniond(Eigen::AngleAxisd(uniform(random, 0, 1.0), random_vector(random, 1.0).normalized()));
    for (Vector3d& joints : at.legs) joints *= k % 2 == 0 ? 0.25 : 0.4;
    const auto poses = modules(octopod(), at);
    const Legs legs = legs_of(at);
    for (const double clearance : {0.0, 0.01}) {
      const double away = std::min(nearest_parts(poses, legs).distance, between_bodies(poses));
      const auto found = touching_itself(octopod(), poses, legs, clearance);
      if (away < clearance) {
        EXPECT_TRUE(found) << away;
      }
      if (away > clearance + 2e-4 && between_bodies(poses) > clearance + 0.02) {
        EXPECT_FALSE(found) << away;
      }
      ++(found ? touching : apart);
    }
  }
  EXPECT_GT(apart, 100);
  EXPECT_GT(touching, 100);
}

TEST(OctopodApart, FoldedBodiesMeetAndStraightOnesDoNot) {
  for (const Vector3d& axis : {Vector3d::UnitY().eval(), Vector3d::UnitZ().eval(), Vector3d(0, 1, 1).normalized().eval()})
    for (double bend = 0.0; bend < 3.0; bend += 0.02) {
      Coordinates at;
      at.ball = Eigen::Quaterniond(Eigen::AngleAxisd(bend, axis));
      const auto poses = modules(octopod(), at);
      const double away = between_bodies(poses);
      for (const double clearance : {0.0, 0.03}) {
        if (away < clearance) {
          EXPECT_TRUE(modules_nearer(octopod(), poses, clearance)) << bend;
        }
        if (away > clearance + 0.03) {
          EXPECT_FALSE(modules_nearer(octopod(), poses, clearance)) << bend;
        }
      }
    }
}

TEST(OctopodApart, WhatStandsOnTheRampsTouchesItselfNowhereAndWhatIsRefusedForItDoes) {
  const TestGround ground(terrain::ramps());
  const terrain::Terrain fine = terrain::subdivide(ground.terrain, 0.1);
  for (const double clearance : {0.0, 0.005}) {
    int stood = 0, refused = 0;
    for (std::size_t t = 0; t < fine.size(); t += 5) {
      if (!fine.ground[t]) continue;
      const Built built =
          stand(octopod(), ground.surface, fine.centroids[t], fine.normals[t], static_cast<int>(t) % kOrientations, clearance);
      if (built.hindrance != Hindrance::kNone && built.hindrance != Hindrance::kSelfContact) continue;
      const auto poses = modules(octopod(), built.standing.at);
      const Nearest nearest = nearest_parts(poses, legs_of(built.standing.at));
      if (built.hindrance == Hindrance::kNone) {
        ++stood;
        EXPECT_GE(nearest.distance, clearance + kApart) << nearest.parts.part << " " << nearest.parts.other;
        continue;
      }
      ++refused;
      EXPECT_LT(nearest.distance, clearance + kApart + 1e-4) << reason(built);
      EXPECT_LT(built.leg, built.other);
      const double away =
          built.other < kLegs
              ? between_legs(leg(octopod(), built.standing.at, built.leg), leg(octopod(), built.standing.at, built.other))
              : to_module(leg(octopod(), built.standing.at, built.leg), built.other - kBodyOfA,
                          poses[static_cast<std::size_t>(built.other - kBodyOfA)], module_of(built.leg) == built.other - kBodyOfA);
      EXPECT_LT(away, clearance + kApart + 1e-4) << reason(built);
    }
    EXPECT_GT(stood, 200);
    EXPECT_GT(refused, 5);
  }
}

TEST(OctopodApart, ARefusalNamesBothAndTurnsWithTheRobot) {
  Built built{.hindrance = Hindrance::kSelfContact, .leg = 1, .figure = 0.001, .other = 3};
  EXPECT_EQ(reason(built), "A2 and A4 are nearer to each other than 0.001 m");
  EXPECT_EQ(reason(turned(octopod(), built)), "B1 and B3 are nearer to each other than 0.001 m");
  built.other = kBodyOfA;
  EXPECT_EQ(reason(built), "A2 and the body of A are nearer to each other than 0.001 m");
  EXPECT_EQ(reason(turned(octopod(), built)), "B3 and the body of B are nearer to each other than 0.001 m");
  built.leg = kBodyOfA;
  built.other = kBodyOfB;
  EXPECT_EQ(reason(turned(octopod(), built)), "the body of A and the body of B are nearer to each other than 0.001 m");
}

}  // namespace
}  // namespace foothold::octopod
