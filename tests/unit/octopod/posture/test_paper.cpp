// Standing up as the paper does: the same feet where its candidates hold them, joints by Newton.
#include <gtest/gtest.h>

#include "independent.hpp"
#include "terrain/centroids.hpp"

namespace foothold::octopod {
namespace {

TEST(OctopodStandPaper, NewtonClosesTheBallJointAndPutsAllFeetDown) {
  const TestGround ground(terrain::subdivide(bumpy_ground(0.03, 2)->terrain, 0.15));
  const terrain::CentroidTree centroids(ground.terrain);
  int stood = 0, alike = 0;
  for (std::size_t t = 0; t < ground.terrain.size(); t += 5) {
    const Vector3d &node = ground.terrain.centroids[t], &normal = ground.terrain.normals[t];
    if (node.head<2>().cwiseAbs().maxCoeff() > 1.0) continue;
    const int axis = static_cast<int>(t) % kAxes;
    const Built paper = stand_paper(octopod(), ground.surface, centroids, node, normal, axis, 0.0);
    const Built ours = stand(octopod(), ground.surface, node, normal, axis, 0.0);
    if (paper.hindrance != Hindrance::kNone) continue;
    ++stood;
    for (int which = 0; which < kLegs; ++which) {
      const auto i = static_cast<std::size_t>(which);
      EXPECT_LT((leg(octopod(), paper.standing.at, which).foot - paper.standing.feet[i].point).norm(), 1e-9);
      // The exact nearest point is never farther than the paper's.
      EXPECT_LT(distance_to_ground(ground.terrain, paper.standing.feet[i].point), 1e-12);
    }
    if (ours.hindrance != Hindrance::kNone) continue;
    bool same = true;
    for (std::size_t i = 0; i < kLegs; ++i) same &= (ours.standing.feet[i].point - paper.standing.feet[i].point).norm() < 1e-9;
    alike += same;
  }
  EXPECT_GT(stood, 30);
  EXPECT_GT(alike, stood / 2);
}

TEST(OctopodStandPaper, WithoutCentroidsNearTheShoulderThereIsNoFoothold) {
  const auto ground = level_ground();
  const TestGround coarse(
      terrain::make_terrain(mesh::joined({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}, {{0, 1, 2}, {0, 2, 3}})));
  const terrain::CentroidTree few(coarse.terrain), many(ground->terrain);
  EXPECT_EQ(stand_paper(octopod(), coarse.surface, few, {0, 0, 0}, Vector3d::UnitZ(), 0, 0.0).hindrance, Hindrance::kNoGround);
  EXPECT_EQ(stand_paper(octopod(), ground->surface, many, {0, 0, 0}, Vector3d::UnitZ(), 0, 0.0).hindrance, Hindrance::kNone);
  EXPECT_EQ(stand(octopod(), coarse.surface, {0, 0, 0}, Vector3d::UnitZ(), 0, 0.0).hindrance, Hindrance::kNone)
      << "the exact nearest point needs no centroid";
}

}  // namespace
}  // namespace foothold::octopod
