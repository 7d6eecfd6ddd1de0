// The symmetries by which poses are folded before a network sees them: shown on postures, and seen in the exact answer.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fixtures.hpp"
#include "hyrecro/model/bodies.hpp"
#include "hyrecro/reach/reachability.hpp"

namespace foothold::hyrecro {
namespace {

using std::numbers::pi;

// Both mechanisms of a leg to the other side and its hip by half a turn: the leg as before, its sole turned by half a turn.
Coordinates turned(Coordinates c, std::size_t leg) {
  c.leg[leg].phi1 = -c.leg[leg].phi1;
  c.leg[leg].phi2 = -c.leg[leg].phi2;
  c.hip[leg] += pi;
  return c;
}
Coordinates mirrored(Coordinates c) {
  c.hip = {-c.hip[0], -c.hip[1]};
  return c;
}

Coordinates random_posture(const Model& m, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit;
  Coordinates out;
  for (Leg& leg : out.leg) {
    const auto pick = [&](double& phi, double& y) {
      phi = m.mechanism.greatest_phi() * (2.0 * unit(random) - 1.0);
      const auto range = m.mechanism.offsets(phi);
      y = range.low + unit(random) * (range.high - range.low);
    };
    pick(leg.phi1, leg.y1);
    pick(leg.phi2, leg.y2);
  }
  for (double& hip : out.hip) hip = pi * (2.0 * unit(random) - 1.0);
  return out;
}

TEST(NetworkSymmetries, GiveAPostureWithinLimitsAndAsFreeAsTheOriginal) {
  const Model m = model();
  const Isometry3d half_turn(Eigen::AngleAxisd(pi, Vector3d::UnitZ()));
  const Eigen::Matrix4d mirror = Eigen::Vector4d(1.0, -1.0, 1.0, 1.0).asDiagonal();
  std::mt19937_64 random(7);
  for (int i = 0; i < 2000; ++i) {
    const Coordinates c = random_posture(m, random);
    const Isometry3d pose = forward(m, c);
    ASSERT_TRUE(within_limits(m, c));
    const double clear = self_distance(bodies_at(m, c, Isometry3d::Identity()));
    const auto judge = [&](const Coordinates& other, const Eigen::Matrix4d& expected, const char* what) {
      ASSERT_NEAR((forward(m, other).matrix() - expected).norm(), 0.0, 1e-12) << what;
      ASSERT_TRUE(within_limits(m, other)) << what;
      ASSERT_NEAR(self_distance(bodies_at(m, other, Isometry3d::Identity())), clear, 1e-9) << what;
    };
    judge(turned(c, 0), (half_turn * pose).matrix(), "the holding sole turned");
    judge(turned(c, 1), (pose * half_turn).matrix(), "the free sole turned");
    judge(mirrored(c), mirror * pose.matrix() * mirror, "mirrored");
    judge(swapped(c), pose.inverse().matrix(), "seen from the other foot");
  }
}

TEST(NetworkSymmetries, LeaveTheExactAnswerAsItIs) {
  const Model m = model();
  const std::unique_ptr<Reachability> exact = make_exact(m, 0.005);
  std::mt19937_64 random(6);
  for (const PoseKind kind : {PoseKind::kFace, PoseKind::kTransition}) {
    constexpr int kCount = 10000;
    const double radius = farthest(kind, m);
    int differ = 0, reachable = 0;
    for (int i = 0; i < kCount; ++i) {
      const Isometry3d pose = random_pose(kind, radius, random);
      const bool original = exact->reach(pose, {}).reachable;
      differ += original != exact->reach(pose_of(inputs_of(kind, pose)), {}).reachable;
      reachable += original;
    }
    // Poses at the workspace's very edge may be missed by the search on one side and the fold rounds to float.
    EXPECT_LE(differ, 1 + reachable / 100) << name_of(kind) << ", " << reachable << " reachable";
    EXPECT_GT(reachable, kCount / 50) << name_of(kind);
  }
}

}  // namespace
}  // namespace foothold::hyrecro
