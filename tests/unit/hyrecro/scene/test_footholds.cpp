// Safe polygons, plates on faces and footholds from poses, each against what it means.
#include <gtest/gtest.h>

#include "samples.hpp"

namespace foothold::hyrecro {
namespace {

const Model kModel = shipped_model();

double distance_to_edges(const truss::Face& face, const Vector2d& point) {
  double least = 1e9;
  const auto ring = [&](const Polygon& polygon) {
    for (std::size_t k = 0; k < polygon.size(); ++k)
      least = std::min(least, geometry::distance(point, polygon[k], polygon[(k + 1) % polygon.size()]));
  };
  ring(face.outline);
  for (const Polygon& hole : face.holes) ring(hole);
  return least;
}

bool on(const truss::Face& face, const Vector2d& point) { return geometry::contains(Region{face.outline, face.holes}, point); }

TEST(Shrunk, HoldsNoPointNearerToAnEdgeThanTheInset) {
  std::mt19937_64 random(3);
  int inside = 0;
  for (int round = 0; round < 300; ++round) {
    const truss::Face face = random_face(random);
    const double inset = uniform(random, 0.0, 0.15);
    for (const Region& region : shrunk(face, inset))
      for (int trial = 0; trial < 100; ++trial) {
        const Vector2d point(uniform(random, -1, 1), uniform(random, -1, 1));
        if (!geometry::contains(region, point)) continue;
        ++inside;
        EXPECT_TRUE(on(face, point));
        EXPECT_GE(distance_to_edges(face, point), inset - 3e-8);
      }
  }
  EXPECT_GT(inside, 3000);
}

// Mitred corners cut off more than the distance alone does at reflex corners only.
TEST(Shrunk, HoldsEveryPointOfAConvexFaceThatKeepsTheInset) {
  std::mt19937_64 random(4);
  int inside = 0;
  for (int round = 0; round < 300; ++round) {
    truss::Face face;
    face.frame = Isometry3d::Identity();
    const int corners = 4 + static_cast<int>(random() % 9);
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * std::numbers::pi * (k + uniform(random, 0.0, 0.5)) / corners;
      face.outline.emplace_back(std::cos(angle), 0.6 * std::sin(angle));
    }
    const double inset = uniform(random, 0.01, 0.3);
    const std::vector<Region> regions = shrunk(face, inset);
    for (int trial = 0; trial < 100; ++trial) {
      const Vector2d point(uniform(random, -1, 1), uniform(random, -1, 1));
      if (!on(face, point) || distance_to_edges(face, point) < inset + 3e-8) continue;
      ++inside;
      ASSERT_EQ(regions.size(), 1u);
      EXPECT_TRUE(geometry::contains(regions[0], point));
    }
  }
  EXPECT_GT(inside, 3000);
}

TEST(Shrunk, OfABeamsSideIsTheSmallerRectangle) {
  const truss::Truss truss = truss::build({"", {{"b", {0, 0, 0}, {1, 0, 0}, 0.15, 0.15, {0, 0, 1}}}, {}});
  const std::vector<Region> regions = shrunk(truss.faces[0], 0.07);
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_NEAR(geometry::area(regions[0]), 0.86 * 0.01, 1e-9);
  EXPECT_TRUE(shrunk(truss.faces[0], 0.076).empty());
}

TEST(Shrunk, FallsIntoPartsWhereAFaceIsNarrow) {
  truss::Face face;
  face.frame = Isometry3d::Identity();
  face.outline = {{0, 0}, {1, 0}, {1, 0.4}, {2, 0.4}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 0.5}, {1, 0.5}, {1, 1}, {0, 1}};
  EXPECT_EQ(shrunk(face, 0.04).size(), 1u);
  EXPECT_EQ(shrunk(face, 0.06).size(), 2u);
}

// Against points of the plate, densely.
TEST(PlateOnFace, MeansThatEveryPointOfThePlateIsOnTheFace) {
  std::mt19937_64 random(5);
  int whole = 0, partly = 0;
  for (int round = 0; round < 4000; ++round) {
    const truss::Face face = random_face(random);
    const Foothold foothold{0, {uniform(random, -0.8, 0.8), uniform(random, -0.8, 0.8)}, uniform(random, -3.2, 3.2)};
    const auto corner = footprint(kModel, foothold);
    double worst = 1e9;  // least depth inside the face of a point of the plate
    constexpr int kPoints = 40;
    for (int a = 0; a <= kPoints; ++a)
      for (int b = 0; b <= kPoints; ++b) {
        const Vector2d point = corner[0] + (corner[1] - corner[0]) * a / kPoints + (corner[3] - corner[0]) * b / kPoints;
        worst = std::min(worst, (on(face, point) ? 1.0 : -1.0) * distance_to_edges(face, point));
      }
    const bool judged = plate_on_face(kModel, face, foothold);
    if (worst < -1e-9) {
      EXPECT_FALSE(judged) << round;
      partly += on(face, foothold.at) ? 1 : 0;
    }
    // Between the points the face may still be left, by less than their spacing.
    if (worst > 0.1 / kPoints) {
      EXPECT_TRUE(judged) << round;
      ++whole;
    }
  }
  EXPECT_GT(whole, 300);
  EXPECT_GT(partly, 300);
}

TEST(PlateOnFace, TakesAPlateThatReachesToTheEdge) {
  const truss::Truss truss = truss::build({"", {{"b", {0, 0, 0}, {1, 0, 0}, 0.1, 0.1, {0, 0, 1}}}, {}});
  EXPECT_TRUE(plate_on_face(kModel, truss.faces[0], {0, {0.45, 0.0}, 0.0}));
  EXPECT_TRUE(plate_on_face(kModel, truss.faces[0], {0, {-0.45, 0.0}, std::numbers::pi / 2.0}));
  EXPECT_FALSE(plate_on_face(kModel, truss.faces[0], {0, {0.45 + 1e-8, 0.0}, 0.0}));
  EXPECT_FALSE(plate_on_face(kModel, truss.faces[0], {0, {0.0, 0.0}, 0.1}));
}

TEST(FootholdAt, GivesBackTheFootholdOfItsPose) {
  const truss::Truss truss = shipped_scene("truss-crossed-beams");
  std::mt19937_64 random(6);
  int found = 0;
  for (int round = 0; round < 2000; ++round) {
    const int face = static_cast<int>(random() % truss.faces.size());
    const truss::Face& on_face = truss.faces[static_cast<std::size_t>(face)];
    const Foothold foothold{face, {uniform(random, -1, 1), uniform(random, -0.075, 0.075)}, uniform(random, -3.1, 3.1)};
    if (!on(on_face, foothold.at)) continue;
    ++found;
    Isometry3d pose = pose_of(truss, foothold);
    EXPECT_TRUE(pose.linear().col(2).isApprox(on_face.frame.linear().col(2), 1e-12));
    pose.translation() += 5e-7 * pose.linear().col(2);
    const auto back = foothold_at(truss, pose, 1e-6);
    ASSERT_TRUE(back.has_value());
    EXPECT_TRUE(pose_of(truss, *back).isApprox(pose_of(truss, foothold), 1e-6));
    pose.translation() += 1e-6 * pose.linear().col(2);
    EXPECT_FALSE(foothold_at(truss, pose, 1e-6).has_value());
    pose = pose_of(truss, foothold) * Eigen::AngleAxisd(2e-6, Vector3d::UnitX());
    EXPECT_FALSE(foothold_at(truss, pose, 1e-6).has_value());
  }
  EXPECT_GT(found, 500);
}

TEST(FootholdAt, FindsNothingOffTheFaces) {
  const truss::Truss truss = shipped_scene("truss-crossed-beams");
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = Vector3d(1.5, 0.0, 0.075);  // inside the crossing
  EXPECT_FALSE(foothold_at(truss, pose, 1e-3).has_value());
  pose.translation() = Vector3d(0.5, 0.08, 0.075);  // beside the beam
  EXPECT_FALSE(foothold_at(truss, pose, 1e-3).has_value());
}

}  // namespace
}  // namespace foothold::hyrecro
