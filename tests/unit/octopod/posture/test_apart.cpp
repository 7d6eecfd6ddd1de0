// Legs and bodies against each other: by many points, on random robots, on standing ones, and on ones that are set up to touch.
#include <gtest/gtest.h>

#include "independent.hpp"
#include "octopod/posture/apart.hpp"
#include "terrain/generate.hpp"

namespace foothold::octopod {
namespace {

using Legs = std::array<LegPoints, kLegs>;

Legs legs_of(const Coordinates& at) {
  Legs out;
  for (int k = 0; k < kLegs; ++k) out[static_cast<std::size_t>(k)] = leg(octopod(), at, k);
  return out;
}

constexpr int kPoints = 80;  // on a link, 1.25 mm apart: a distance of 1 cm or more comes out less than 0.02 mm too great

// Points on both links of a leg, or on its tibia alone.
template <class Visit>
void along(const LegPoints& at, bool femur_too, Visit&& visit) {
  for (int k = 0; k <= kPoints; ++k) {
    const double part = static_cast<double>(k) / kPoints;
    if (femur_too) visit(Vector3d(at.shoulder + part * (at.knee - at.shoulder)));
    visit(Vector3d(at.knee + part * (at.foot - at.knee)));
  }
}

double between_legs(const LegPoints& a, const LegPoints& b) {
  double least = INFINITY;
  along(a, true, [&](const Vector3d& p) {
    least = std::min({least, squared_to_segment(p, b.shoulder, b.knee), squared_to_segment(p, b.knee, b.foot)});
  });
  return std::sqrt(least) - 2 * octopod().leg_radius;
}

double to_module(const LegPoints& at, int module, const Isometry3d& pose, bool own) {
  const Vector3d half = octopod().body / 2;
  const double forth = module == 0 ? -1.0 : 1.0;
  const Vector3d neck = pose * Vector3d(forth * half.x(), 0, 0), joint = pose * Vector3d(forth * octopod().arm(), 0, 0);
  double least = INFINITY;
  along(at, !own, [&](const Vector3d& p) {
    const Vector3d seen = pose.inverse() * p;
    least = std::min({least, (seen - seen.cwiseMin(half).cwiseMax(-half)).norm(),
                      std::sqrt(squared_to_segment(p, neck, joint)) - octopod().neck_radius});
  });
  return least - octopod().leg_radius;
}

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

// The two parts nearest to each other, legs and legs with modules.
struct Nearest {
  double distance = INFINITY;
  Touch parts;
};
Nearest nearest_parts(const std::array<Isometry3d, 2>& poses, const Legs& legs) {
  Nearest out;
  for (int i = 0; i < kLegs; ++i) {
    const LegPoints& at = legs[static_cast<std::size_t>(i)];
    for (int j = i + 1; j < kLegs; ++j)
      if (const double away = between_legs(at, legs[static_cast<std::size_t>(j)]); away < out.distance) out = {away, {i, j}};
    for (int m = 0; m < 2; ++m)
      if (const double away = to_module(at, m, poses[static_cast<std::size_t>(m)], module_of(i) == m); away < out.distance)
        out = {away, {i, kBodyOfA + m}};
  }
  return out;
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
