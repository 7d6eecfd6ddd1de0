// Painter's order: whatever is nearer comes later wherever two faces overlap.
#include "painter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace foothold::drawing {
namespace {

SeenFace face(std::size_t body, Points points) {
  std::vector<bool> edges(points.size(), true);
  return {std::move(points), std::move(edges), 0, body};
}

std::vector<std::size_t> bodies(const std::vector<SeenFace>& faces) {
  std::vector<std::size_t> order;
  for (const SeenFace& one : faces) order.push_back(one.body);
  return order;
}

// Fails unless no face hides a part of one that is drawn after it.
void expect_painters_order(const std::vector<SeenFace>& faces, double slack) {
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t k = i + 1; k < faces.size(); ++k) {
      const Points common = overlap(faces[i].points, faces[k].points);
      if (common.empty() || flat_area(common) < 0.1) continue;
      const auto later = depth_plane(faces[k].points);
      ASSERT_TRUE(later.has_value());
      for (const Vector3d& p : common)
        EXPECT_LE(p.z(), (*later)(p) + slack) << "faces " << faces[i].body << " and " << faces[k].body;
    }
}

double area_of(const std::vector<SeenFace>& faces, std::size_t body) {
  double area = 0.0;
  for (const SeenFace& one : faces)
    if (one.body == body) area += flat_area(one.points);
  return area;
}

// A long bar from `a` to `b` on the screen, `half` wide to each side.
SeenFace bar(std::size_t body, const Vector3d& a, const Vector3d& b, double half) {
  const Vector2d along = (b - a).head<2>().normalized();
  const Vector3d side(-along.y() * half, along.x() * half, 0.0);
  return face(body, {a - side, b - side, b + side, a + side});
}

TEST(Painter, NearerFaceComesLater) {
  const auto far_face = face(0, {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}});
  const auto near_face = face(1, {{5, 5, 3}, {15, 5, 3}, {15, 15, 3}, {5, 15, 3}});
  EXPECT_EQ(bodies(painters_order({far_face, near_face})), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(bodies(painters_order({near_face, far_face})), (std::vector<std::size_t>{0, 1}));
}

// A long floor reaches nearer to the viewer than a small box on its far end, and yet lies behind it: mean depths would lie.
TEST(Painter, SmallThingOnTheFarEndOfAFloorComesAfterTheFloor) {
  const auto floor = face(0, {{0, 0, 0}, {100, 0, 100}, {100, 20, 100}, {0, 20, 0}});
  const auto thing = face(1, {{5, 5, 16}, {15, 5, 16}, {15, 15, 16}, {5, 15, 16}});
  EXPECT_EQ(bodies(painters_order({thing, floor})), (std::vector<std::size_t>{0, 1}));
}

TEST(Painter, FacesThatPassThroughEachOtherAreCut) {
  const auto flat = face(0, {{0, 0, 0}, {20, 0, 0}, {20, 10, 0}, {0, 10, 0}});
  const auto slope = face(1, {{0, 2, -10}, {20, 2, 10}, {20, 8, 10}, {0, 8, -10}});
  const auto order = painters_order({flat, slope});
  EXPECT_EQ(order.size(), 3u);
  expect_painters_order(order, kSameDepth);
  EXPECT_NEAR(area_of(order, 0), 200.0, 1e-9);
  EXPECT_NEAR(area_of(order, 1), 120.0, 1e-9);
}

TEST(Painter, RingOfThreeBarsIsOpenedByACut) {
  // Each bar rises: its begin lies under the one before it, its end over the one after it.
  const std::vector<SeenFace> ring{bar(0, {0, 0, -10}, {100, 0, 10}, 4), bar(1, {90, -10, -10}, {40, 80, 10}, 4),
                                   bar(2, {60, 80, -10}, {10, -10, 10}, 4)};
  const auto order = painters_order(ring);
  EXPECT_GT(order.size(), 3u);
  expect_painters_order(order, kSameDepth);
  for (std::size_t body = 0; body < 3; ++body) EXPECT_NEAR(area_of(order, body), flat_area(ring[body].points), 1e-6);
}

TEST(Painter, CoincidingFacesKeepTheirOrder) {
  const Points points{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  EXPECT_EQ(bodies(painters_order({face(4, points), face(2, points), face(7, points)})), (std::vector<std::size_t>{4, 2, 7}));
}

TEST(Painter, CutEdgesAreNoOutlines) {
  const auto flat = face(0, {{0, 0, 0}, {20, 0, 0}, {20, 10, 0}, {0, 10, 0}});
  const auto slope = face(1, {{0, 2, -10}, {20, 2, 10}, {20, 8, 10}, {0, 8, -10}});
  double outline = 0.0;
  for (const SeenFace& one : painters_order({flat, slope})) {
    if (one.body != 1) continue;
    for (std::size_t i = 0; i < one.points.size(); ++i)
      if (one.outline[i]) outline += (one.points[(i + 1) % one.points.size()] - one.points[i]).head<2>().norm();
  }
  EXPECT_NEAR(outline, 2.0 * (20.0 + 6.0), 1e-9);
}

// Random triangles that meet and pass through each other in every way.
TEST(Painter, RandomTrianglesAreInOrderWhereverTheyOverlap) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> across(0.0, 200.0), deep(-50.0, 50.0);
  for (int run = 0; run < 5; ++run) {
    std::vector<SeenFace> faces;
    double area = 0.0;
    for (std::size_t i = 0; i < 25; ++i) {
      faces.push_back(face(i, {{across(random), across(random), deep(random)},
                               {across(random), across(random), deep(random)},
                               {across(random), across(random), deep(random)}}));
      area += flat_area(faces.back().points);
    }
    const auto order = painters_order(faces);
    double after = 0.0;
    for (const SeenFace& one : order) after += flat_area(one.points);
    EXPECT_NEAR(after, area, 1e-6 * area);
    expect_painters_order(order, 1.0);
  }
}

TEST(Painter, NothingGivesNothing) { EXPECT_TRUE(painters_order({}).empty()); }

}  // namespace
}  // namespace foothold::drawing
