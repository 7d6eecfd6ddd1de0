// Prepared scenes: what is drawn of them, and random starts and goals.
#include "hyrecro/scene/prepared.hpp"

#include <gtest/gtest.h>

#include "hyrecro/scene/random_foothold.hpp"
#include "samples.hpp"
#include "truss/generate.hpp"

namespace foothold::hyrecro {
namespace {

const Model kModel = shipped_model();

double area_of(const std::vector<Vector3d>& polygon) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) sum += 0.5 * (polygon[k] - polygon[0]).cross(polygon[k + 1] - polygon[0]);
  return sum.norm();
}

TEST(PreparedTruss, DrawsBeamsAsBoxesAndFacesAsPolygonsWithoutTheirHoles) {
  // A post goes through a wall that is given as a face.
  const truss::Truss truss = truss::build({"",
                                           {{"post", {0.5, -1, 0.5}, {0.5, 1, 0.5}, 0.2, 0.3, {0, 0, 1}}},
                                           {{"wall", {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, {0, -1, 0}}}});
  const PreparedTruss scene(kModel, truss, {}, 0.005);
  double area = 0.0;
  int boxes = 0;
  for (const Shape& shape : scene.shapes()) {
    if (shape.kind == Shape::Kind::kBox) {
      ++boxes;
      EXPECT_EQ(shape.body, "post");
      EXPECT_TRUE(shape.size.isApprox(Vector3d(2.0, 0.2, 0.3)));
      continue;
    }
    ASSERT_EQ(shape.kind, Shape::Kind::kPolygon);
    EXPECT_EQ(shape.body, "wall");
    for (const Vector3d& v : shape.vertices) EXPECT_NEAR(v.y(), 0.0, 1e-9);
    area += area_of(shape.vertices);
  }
  EXPECT_EQ(boxes, 1);
  EXPECT_NEAR(area, 1.0 - 0.2 * 0.3, 1e-6);
}

TEST(RandomFoothold, LiesFullyOnAFaceAndIsTheSameFromTheSameSeed) {
  const truss::Truss truss = truss::build(truss::generate(truss::Family::kTower, 3, 20));
  std::mt19937_64 random(1), same(1);
  for (int round = 0; round < 300; ++round) {
    const auto foothold = random_foothold(kModel, truss, random), again = random_foothold(kModel, truss, same);
    ASSERT_TRUE(foothold.has_value());
    EXPECT_TRUE(plate_on_face(kModel, truss.faces[static_cast<std::size_t>(foothold->face)], *foothold));
    EXPECT_EQ(foothold->face, again->face);
    EXPECT_EQ(foothold->at, again->at);
    EXPECT_EQ(foothold->heading, again->heading);
  }
}

TEST(RandomFoothold, IsNoneWhereNoPlateFits) {
  const truss::Truss truss = truss::build({"", {{"rod", {0, 0, 0}, {1, 0, 0}, 0.05, 0.05, {0, 0, 1}}}, {}});
  std::mt19937_64 random(1);
  EXPECT_FALSE(random_foothold(kModel, truss, random).has_value());
  EXPECT_FALSE(random_foothold(kModel, truss::Truss{}, random).has_value());
}

}  // namespace
}  // namespace foothold::hyrecro
