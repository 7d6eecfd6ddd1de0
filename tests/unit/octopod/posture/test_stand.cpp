// The octopod over nodes of all kinds of ground.
#include <gtest/gtest.h>

#include "independent.hpp"

namespace foothold::octopod {
namespace {

Built over(const TestGround& ground, int triangle, int orientation, double clearance = 0.0) {
  const auto t = static_cast<std::size_t>(triangle);
  return stand(octopod(), ground.surface, ground.terrain.centroids[t], ground.terrain.normals[t], orientation, clearance);
}

// Triangles far enough from the border for all feet.
std::vector<int> inner(const TestGround& ground) {
  std::vector<int> out;
  for (int t = 0; t < static_cast<int>(ground.terrain.size()); ++t)
    if (ground.terrain.centroids[static_cast<std::size_t>(t)].head<2>().cwiseAbs().maxCoeff() < 1.0) out.push_back(t);
  return out;
}

TEST(OctopodStand, OnLevelGroundBodiesAreLevelAndFeetUnderTheirKnees) {
  const auto ground = level_ground();
  for (int heading = 0; heading < kOrientations; ++heading) {
    const Built built = stand(octopod(), ground->surface, {0.1, -0.2, 0}, Vector3d::UnitZ(), heading, 0.0);
    ASSERT_EQ(built.hindrance, Hindrance::kNone) << reason(built);
    const double angle = heading * std::numbers::pi / 4;
    const Vector3d axis(std::cos(angle), std::sin(angle), 0), left(-axis.y(), axis.x(), 0);
    const Vector3d joint(0.1, -0.2, 0.12);
    EXPECT_LT((built.standing.at.front.translation() - joint - 0.16 * axis).norm(), 1e-14);
    EXPECT_LT((built.standing.rear.translation() - joint + 0.16 * axis).norm(), 1e-14);
    EXPECT_LT((built.standing.at.front.linear().col(0) - axis).norm(), 1e-14);
    for (int leg_index = 0; leg_index < kLegs; ++leg_index) {
      const double forth = (leg_index < 4 ? 0.16 : -0.16) + (leg_index % 4 < 2 ? 0.1 : -0.1);
      const Vector3d foot = joint + forth * axis + 0.18 * side(leg_index) * left - Vector3d(0, 0, 0.12);
      EXPECT_LT((built.standing.feet[static_cast<std::size_t>(leg_index)].point - foot).norm(), 1e-14) << limb(leg_index);
      EXPECT_LT((leg(octopod(), built.standing.at, leg_index).foot - foot).norm(), 1e-14) << limb(leg_index);
    }
    EXPECT_LT((built.standing.centre_of_mass - centre_of_mass(octopod(), built.standing.at)).norm(), 1e-14);
    EXPECT_LT(built.standing.residual, 1e-14);
  }
}

TEST(OctopodStand, BodiesFollowTheNormalsBeneathAndFeetAreTheNearestPoints) {
  int unmoved = 0;
  for (const double size : {0.02, 0.05}) {
    const auto ground = bumpy_ground(size, 7);
    for (const int t : inner(*ground)) {
      if (t % 3 != 0) continue;
      const auto i = static_cast<std::size_t>(t);
      const Built built = over(*ground, t, t % kAxes);
      if (built.hindrance != Hindrance::kNone) continue;
      const Vector3d node = ground->terrain.centroids[i], normal = ground->terrain.normals[i];
      const Vector3d joint = node + 0.12 * normal;
      if ((centre(octopod(), built.standing.at) - joint).norm() > 1e-12) continue;  // a leg did not reach: another test
      ++unmoved;
      const auto poses = modules(octopod(), built.standing.at);
      EXPECT_LT((poses[1].matrix() - built.standing.rear.matrix()).norm(), 1e-14);
      for (int which = 0; which < kLegs; ++which) {
        const Isometry3d& module = poses[static_cast<std::size_t>(which / 4)];
        const Footing& footing = built.standing.feet[static_cast<std::size_t>(which)];
        const Vector3d in_the_air =
            module * (octopod().shoulders[static_cast<std::size_t>(which % 4)] + Vector3d(0, 0.1 * side(which), -0.1));
        EXPECT_NEAR((footing.point - in_the_air).norm(), distance_to_ground(ground->terrain, in_the_air), 1e-12);
        EXPECT_LT((leg(octopod(), built.standing.at, which).foot - footing.point).norm(), 1e-9);
        EXPECT_EQ(footing.normal, ground->terrain.normals[static_cast<std::size_t>(footing.triangle)]);
      }
      for (const double end : {1.0, -1.0}) {
        const Isometry3d& module = poses[end > 0 ? 0 : 1];
        const Vector3d z = module.linear().col(2), x = module.linear().col(0);
        EXPECT_NEAR(x.dot(module.linear().col(1)), 0.0, 1e-14);
        EXPECT_NEAR(normal.dot(x.cross(z)), normal.dot(-module.linear().col(1)), 1e-12);
        bool of_the_ground = false;
        for (const Vector3d& one : ground->terrain.normals) of_the_ground |= (one - z).norm() < 1e-12;
        EXPECT_TRUE(of_the_ground);
      }
    }
  }
  EXPECT_GT(unmoved, 80);
}

TEST(OctopodStand, WhatStandsIsClearOfTheGroundAndWhatIsRefusedForATouchIsNot) {
  const auto ground = bumpy_ground(0.12, 3);
  int stood = 0, touched = 0, other = 0;
  for (const int t : inner(*ground)) {
    const Built built = over(*ground, t, t % kAxes);
    if (built.hindrance == Hindrance::kNone) {
      ++stood;
      EXPECT_LT(built.standing.residual, 1e-9);
      EXPECT_LT(depth(octopod(), ground->terrain, built.standing.at, 0.02), 0.0);
    } else if (built.hindrance == Hindrance::kCollision) {
      // Bodies without the legs' own radius may be clear by less than that.
      ++touched;
      EXPECT_GT(depth(octopod(), ground->terrain, built.standing.at, 0.01, 30), -0.02) << reason(built);
    } else {
      ++other;
    }
  }
  EXPECT_GT(stood, 40);
  EXPECT_GT(touched, 20);
}

TEST(OctopodStand, BodiesMoveWhereALegDoesNotReachAndOnlyThere) {
  int moved = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const auto ground = ground_of(1.5, 8, [&, random = std::mt19937_64(seed)](double, double) mutable {
      return uniform(random, 0, 1) < 0.15 ? -uniform(random, 0.05, 0.25) : 0.0;
    });
    for (const int t : inner(*ground)) {
      if (t % 4 != 0) continue;
      const auto i = static_cast<std::size_t>(t);
      const Built built = over(*ground, t, t % kAxes);
      if (built.hindrance != Hindrance::kNone) continue;
      EXPECT_LT(built.standing.residual, 1e-9);
      const Vector3d joint = ground->terrain.centroids[i] + 0.12 * ground->terrain.normals[i];
      const double by = (centre(octopod(), built.standing.at) - joint).norm();
      double longest = 0.0;
      for (int which = 0; which < kLegs; ++which) {
        const LegPoints at = leg(octopod(), built.standing.at, which);
        longest = std::max(longest, (at.foot - at.shoulder).norm());
      }
      EXPECT_LE(longest, octopod().reach());
      if (by > 1e-12) {
        ++moved;
        EXPECT_GT(longest, 0.98 * octopod().reach()) << "moved without need";
      }
    }
  }
  EXPECT_GT(moved, 10);
}

TEST(OctopodStand, AFootholdTooFarAwayIsRefusedWithItsLeg) {
  const auto ground = level_ground();
  const Built near = stand(octopod(), ground->surface, {0, 0, 0.05}, Vector3d::UnitZ(), 1, 0.0);
  EXPECT_EQ(near.hindrance, Hindrance::kNone) << "the bodies come down a little: " << reason(near);
  const Built high = stand(octopod(), ground->surface, {0, 0, 0.2}, Vector3d::UnitZ(), 1, 0.0);
  ASSERT_EQ(high.hindrance, Hindrance::kOutOfReach) << reason(high);
  EXPECT_GE(high.leg, 0);
  EXPECT_NEAR(high.figure, std::hypot(0.1, 0.32) - 0.199, 1e-12) << "from where the bodies were first";
  EXPECT_NE(reason(high).find("leg " + limb(high.leg) + " misses its foothold by"), std::string::npos) << reason(high);
}

TEST(OctopodStand, ASpikeUnderABodyOrALegIsRefused) {
  // A needle of 2 mm at (x, y), as high as `height`.
  const auto with_needle = [](double x, double y, double height) {
    const double w = 0.001;
    return std::make_unique<TestGround>(terrain::make_terrain(mesh::joined(
        {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, {x - w, y - w, 0}, {x + w, y - w, 0}, {x, y + w, 0}, {x, y, height}},
        {{0, 1, 2}, {0, 2, 3}, {4, 5, 7}, {5, 6, 7}, {6, 4, 7}, {5, 4, 6}})));
  };
  const auto stood_with = [&](double x, double y, double height, double clearance) {
    const auto ground = with_needle(x, y, height);
    return stand(octopod(), ground->surface, {0, 0, 0}, Vector3d::UnitZ(), 0, clearance);
  };
  EXPECT_EQ(stood_with(0.19, 0.05, 0.093, 0.0).hindrance, Hindrance::kNone) << "the body's underside is 0.095 m high";
  EXPECT_EQ(stood_with(0.19, 0.05, 0.093, 0.005).hindrance, Hindrance::kCollision);
  const Built body = stood_with(0.19, 0.05, 0.097, 0.0);
  EXPECT_EQ(body.hindrance, Hindrance::kCollision);
  EXPECT_EQ(body.leg, -1);
  EXPECT_EQ(reason(body), "a body touches the ground");
  const Built neck = stood_with(0.03, 0.0, 0.11, 0.0);
  EXPECT_EQ(neck.hindrance, Hindrance::kCollision);
  EXPECT_EQ(neck.leg, -1);
  const Built femur = stood_with(0.26, 0.12, 0.135, 0.0);
  EXPECT_EQ(femur.hindrance, Hindrance::kCollision);
  EXPECT_EQ(femur.leg, 0);
  EXPECT_EQ(stood_with(0.0, 0.3, 0.3, 0.0).hindrance, Hindrance::kNone) << "the needle stands beside the robot";
}

TEST(OctopodStand, ARobotUnderTheGroundIsRefused) {
  std::vector<Vector3d> vertices{{-2, -2, 0},   {2, -2, 0},   {2, 2, 0},   {-2, 2, 0},
                                 {-2, -2, 0.4}, {2, -2, 0.4}, {2, 2, 0.4}, {-2, 2, 0.4}};
  const TestGround ground(terrain::make_terrain(mesh::joined(vertices, {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}})));
  EXPECT_EQ(stand(octopod(), ground.surface, {0, 0, 0}, Vector3d::UnitZ(), 0, 0.0).hindrance, Hindrance::kCollision);
  EXPECT_EQ(stand(octopod(), ground.surface, {0, 0, 0.4}, Vector3d::UnitZ(), 0, 0.0).hindrance, Hindrance::kNone);
}

TEST(OctopodStand, TheSameQuestionHasTheSameAnswerBitByBit) {
  const auto ground = bumpy_ground(0.05, 9);
  for (const int t : inner(*ground)) {
    const Built a = over(*ground, t, t % kOrientations), b = over(*ground, t, t % kOrientations);
    EXPECT_EQ(a.hindrance, b.hindrance);
    EXPECT_EQ(a.standing.at.legs, b.standing.at.legs);
    EXPECT_EQ(a.standing.at.front.matrix(), b.standing.at.front.matrix());
  }
}

}  // namespace
}  // namespace foothold::octopod
