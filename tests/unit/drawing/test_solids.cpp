// Bodies on the screen, against closed forms.
#include "solids.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace foothold::drawing {
namespace {

Body body(msg::ShapeKind kind, const Vector3d& size, const Isometry3d& pose = Isometry3d::Identity()) {
  Body result;
  result.kind = kind;
  result.size = size;
  result.pose = pose;
  return result;
}

double outline_length(const std::vector<SeenFace>& faces) {
  double length = 0.0;
  for (const SeenFace& face : faces)
    for (std::size_t i = 0; i < face.points.size(); ++i)
      if (face.outline[i]) length += (face.points[(i + 1) % face.points.size()] - face.points[i]).head<2>().norm();
  return length;
}

double area(const std::vector<SeenFace>& faces) {
  return std::accumulate(faces.begin(), faces.end(), 0.0,
                         [](double sum, const SeenFace& face) { return sum + flat_area(face.points); });
}

const Isometry3d kLying(Eigen::AngleAxisd(M_PI / 2.0, Vector3d::UnitY()));

TEST(Solids, BoxShowsOneFaceFromAboveAndThreeObliquely) {
  const Body box = body(msg::BOX, {1.0, 2.0, 3.0});
  const Projection above{camera_above(), Vector3d::Zero(), {0.0, 0.0}, 10.0};
  const auto top = seen_faces(box, above, 7);
  ASSERT_EQ(top.size(), 1u);
  EXPECT_NEAR(flat_area(top[0].points), 200.0, 1e-9);
  EXPECT_NEAR(top[0].points[0].z(), 15.0, 1e-9);
  EXPECT_EQ(top[0].body, 7u);
  EXPECT_EQ(seen_faces(box, {camera_oblique(-60.0, 30.0), Vector3d::Zero(), {0.0, 0.0}, 10.0}, 0).size(), 3u);
}

TEST(Solids, FacesOfABoxCoverItsSilhouette) {
  const Isometry3d pose(Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.7, Vector3d(1, -2, 0.5).normalized()));
  const Body box = body(msg::BOX, {1.0, 0.5, 0.2}, pose);
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += 50.0) {
    const Projection view{camera_oblique(azimuth, 25.0), Vector3d::Zero(), {0.0, 0.0}, 100.0};
    EXPECT_NEAR(area(seen_faces(box, view, 0)), flat_area(outline(box, view).polygons.at(0)), 1e-6);
  }
}

TEST(Solids, FacesOfABoxTurnOutward) {
  const Body box = body(msg::BOX, {1.0, 2.0, 3.0}, kLying);
  for (const Points& face : box_faces(box)) EXPECT_GT(newell(face).dot(mean(face)), 0.0);
}

TEST(Solids, LyingCapsuleIsAStripWithTwoHalfDiscs) {
  const Body capsule = body(msg::CAPSULE, {0.1, 0.0, 1.0}, kLying);
  const Projection above{camera_above(), Vector3d::Zero(), {0.0, 0.0}, 100.0};
  const auto faces = seen_faces(capsule, above, 0);
  ASSERT_EQ(faces.size(), 3u);
  // The half discs are polygons of 12 sides: 1.2 % less than round ones.
  EXPECT_NEAR(area(faces), 100.0 * 20.0 + M_PI * 100.0, 0.013 * M_PI * 100.0);
  EXPECT_NEAR(outline_length(faces), 2.0 * 100.0 + 2.0 * M_PI * 10.0, 0.4);
  for (const SeenFace& face : faces)
    for (const Vector3d& p : face.points) EXPECT_NEAR(p.z(), 0.0, 1e-9) << "the section goes through the axis";
}

TEST(Solids, CapsuleSeenAlongItsAxisIsADiscAtItsNearerEnd) {
  const Body capsule = body(msg::CAPSULE, {0.1, 0.0, 1.0});
  const auto faces = seen_faces(capsule, {camera_above(), Vector3d::Zero(), {0.0, 0.0}, 100.0}, 0);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_NEAR(flat_area(faces[0].points), M_PI * 100.0, 0.013 * M_PI * 100.0);
  EXPECT_NEAR(faces[0].points[0].z(), 50.0, 1e-9);
}

TEST(Solids, SlantingCapsulesSectionStaysInsideTheCapsule) {
  const Isometry3d pose(Eigen::AngleAxisd(0.8, Vector3d(0.3, 1.0, 0.0).normalized()));
  const Body capsule = body(msg::CAPSULE, {0.1, 0.0, 1.0}, pose);
  const Projection view{camera_oblique(-60.0, 30.0), Vector3d::Zero(), {0.0, 0.0}, 1.0};
  const auto [from, to] = axis_ends(capsule);
  for (const SeenFace& face : seen_faces(capsule, view, 0))
    for (const Vector3d& seen : face.points) {
      const Vector3d p = view.camera.right * seen.x() - view.camera.up * seen.y() + view.camera.towards * seen.z();
      const double along = std::clamp((p - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
      EXPECT_LE((p - (from + along * (to - from))).norm(), 0.1 + 1e-9);
    }
}

TEST(Solids, PolygonIsSeenFromBothSidesWithTheSameBrightnessAsItsVisibleSide) {
  Body polygon = body(msg::POLYGON, Vector3d::Zero());
  polygon.pieces = convex_pieces({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  const Projection above{camera_above(), Vector3d::Zero(), {0.0, 0.0}, 100.0};
  const auto front = seen_faces(polygon, above, 0);
  polygon.pieces = convex_pieces({{0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}});
  const auto back = seen_faces(polygon, above, 0);
  ASSERT_EQ(front.size(), 1u);
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(front[0].shade, back[0].shade);
  EXPECT_EQ(front[0].shade, shade_of(Vector3d::UnitZ()));
}

TEST(Solids, SlopesDifferInBrightness) {
  const Vector3d gentle = Vector3d(0.2, 0.2, 1.0).normalized();
  EXPECT_LT(shade_of(gentle), shade_of(Vector3d::UnitZ()));
  EXPECT_LT(shade_of(-Vector3d::UnitZ()), shade_of(gentle));
  for (const Vector3d& n :
       {Vector3d(Vector3d::UnitX()), Vector3d(-Vector3d::UnitX()), Vector3d(Vector3d::UnitY()), Vector3d(-Vector3d::UnitZ())}) {
    EXPECT_GE(shade_of(n), 0);
    EXPECT_LT(shade_of(n), kShades);
  }
}

TEST(Solids, BoundingPointsBoundEveryBody) {
  const Isometry3d pose(Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.7, Vector3d(1, -2, 0.5).normalized()));
  const Camera camera = camera_oblique(-60.0, 30.0);
  for (const msg::ShapeKind kind : {msg::BOX, msg::CAPSULE, msg::SPHERE}) {
    const Body one = body(kind, {0.2, 0.3, 0.7}, pose);
    const Projection view{camera, Vector3d::Zero(), {0.0, 0.0}, 1.0};
    const Box2 bounds = flat_bounds(view(bounding_points(one, camera)));
    Box2 seen{bounds.high, bounds.low};
    for (const SeenFace& face : seen_faces(one, view, 0)) {
      const Box2 part = flat_bounds(face.points);
      seen = {seen.low.cwiseMin(part.low), seen.high.cwiseMax(part.high)};
    }
    // Half discs are polygons here: their sides lie up to 0.9 % of the radius inside.
    EXPECT_TRUE((bounds.low - seen.low).cwiseAbs().maxCoeff() < 0.003) << kind;
    EXPECT_TRUE((bounds.high - seen.high).cwiseAbs().maxCoeff() < 0.003) << kind;
  }
}

}  // namespace
}  // namespace foothold::drawing
