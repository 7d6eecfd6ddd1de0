// The bounds of how far bodies get between two points of a motion hold all along the way, and are not idle.
#include <gtest/gtest.h>

#include "octopod/check/bodies.hpp"
#include "robot.hpp"

namespace foothold::octopod {
namespace {

struct Move {
  Pose from, to;
};

// `size`: rad and m.
Move random_move(std::mt19937_64& random, double size) {
  const Posture a = to_posture(random_coordinates(random));
  Move out{{a.base, a.joints}, {a.base, a.joints}};
  out.to.base.translation() += random_vector(random, size);
  out.to.base.linear() =
      (a.base.linear() * Eigen::AngleAxisd(uniform(random, 0.0, size), random_vector(random, 1.0).normalized())).eval();
  for (double& joint : out.to.joints) joint += uniform(random, -size, size);
  return out;
}

Skeleton at(const Pose& pose) { return skeleton(octopod(), pose.base, pose.joints); }

TEST(Ways, BoundHowFarPointsGetAndHowFarTheyBulge) {
  std::mt19937_64 random(4);
  double used = 0.0, used_bulge = 0.0;
  for (int run = 0; run < 300; ++run) {
    const Move move = random_move(random, run % 2 == 0 ? 0.3 : 0.02);
    const Ways ways(octopod(), move.from, move.to);
    const Skeleton first = at(move.from), last = at(move.to);
    for (int i = 1; i < 20; ++i) {
      const double part = i / 20.0;
      const Skeleton now = at(between(move.from, move.to, part));
      const auto straight = [&](const Vector3d& a, const Vector3d& b) { return (a + part * (b - a)).eval(); };
      EXPECT_LE((now.centre_of_mass - straight(first.centre_of_mass, last.centre_of_mass)).norm(),
                ways.bulge_of_centre_of_mass() + 1e-12);
      for (int k = 0; k < kLegs; ++k) {
        const auto leg = static_cast<std::size_t>(k);
        const double gone = (now.limbs[leg].foot - first.limbs[leg].foot).norm();
        const double bulge = (now.limbs[leg].foot - straight(first.limbs[leg].foot, last.limbs[leg].foot)).norm();
        EXPECT_LE(gone, ways.of_foot(k) + 1e-12);
        EXPECT_LE((now.limbs[leg].ankle - first.limbs[leg].ankle).norm(), ways.of_body(5 + 2 * k) + 1e-12);
        EXPECT_LE((now.limbs[leg].knee - first.limbs[leg].knee).norm(), ways.of_body(4 + 2 * k) + 1e-12);
        EXPECT_LE(bulge, ways.bulge_of_foot(k) + 1e-12);
        used = std::max(used, gone / ways.of_foot(k));
        used_bulge = std::max(used_bulge, bulge / ways.bulge_of_foot(k));
      }
      for (const std::size_t module : {std::size_t{0}, std::size_t{1}})
        for (int corner = 0; corner < 8; ++corner) {
          const Vector3d p = 0.5 * octopod().body.cwiseProduct(Vector3d((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                                                                        (corner & 4) != 0 ? 1 : -1));
          EXPECT_LE((now.module[module] * p - first.module[module] * p).norm(), ways.of_body(static_cast<int>(module)) + 1e-12);
        }
      EXPECT_LE((now.joint - first.joint).norm(), std::min(ways.of_body(2), ways.of_body(3)) + 1e-12);
    }
  }
  EXPECT_GT(used, 0.5);
  EXPECT_GT(used_bulge, 0.2);
}

TEST(Ways, ArePartsThatEndWhereTheyShould) {
  std::mt19937_64 random(5);
  const Move move = random_move(random, 0.3);
  EXPECT_TRUE(between(move.from, move.to, 0.0).base.isApprox(move.from.base, 1e-12));
  EXPECT_TRUE(between(move.from, move.to, 1.0).base.isApprox(move.to.base, 1e-12));
  EXPECT_EQ(between(move.from, move.to, 1.0).joints.size(), move.to.joints.size());
}

}  // namespace
}  // namespace foothold::octopod
