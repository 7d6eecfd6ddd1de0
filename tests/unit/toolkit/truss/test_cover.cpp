// What is cut out of faces, against areas and points found without clipping.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "geometry/region.hpp"
#include "truss/layout.hpp"

namespace foothold::truss {
namespace {

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

std::map<std::string, double> areas(const Truss& truss) {
  std::map<std::string, double> out;
  for (const Face& face : truss.faces) out[face.name] = geometry::area({face.outline, face.holes});
  return out;
}

TEST(Cover, CutsTheFaceOnWhichABeamStandsAndTheOneThatItStandsOn) {
  const Truss truss =
      build({"", {{"bar", {0, 0, 0}, {2, 0, 0}, 0.2, 0.2, {0, 0, 1}}, {"post", {1, 0, 0.1}, {1, 0, 1}, 0.1, 0.1, {1, 0, 0}}}, {}});
  const auto area = areas(truss);
  EXPECT_EQ(area.count("post/begin"), 0u);
  ASSERT_EQ(area.count("bar/top"), 1u);
  EXPECT_NEAR(area.at("bar/top"), 0.4 - 0.01, 1e-7);
  for (const Face& face : truss.faces) EXPECT_EQ(face.holes.size(), face.name == "bar/top" ? 1u : 0u) << face.name;
}

TEST(Cover, LeavesABeamAloneThatEndsShortOfAnother) {
  const Truss truss = build(
      {"", {{"bar", {0, 0, 0}, {2, 0, 0}, 0.2, 0.2, {0, 0, 1}}, {"post", {1, 0, 0.10001}, {1, 0, 1}, 0.1, 0.1, {1, 0, 0}}}, {}});
  EXPECT_EQ(truss.faces.size(), 12u);
}

TEST(Cover, LeavesFlushFacesWhole) {
  const Truss truss = read_truss(std::string(FOOTHOLD_SCENES) + "/truss-crossed-beams.yaml");
  const auto area = areas(truss);
  EXPECT_EQ(truss.faces.size(), 16u);  // top and bottom of both fall in two
  EXPECT_NEAR(area.at("long/left"), 2.0 * 0.15, 1e-12);
  EXPECT_NEAR(area.at("short/right"), 1.0 * 0.15, 1e-12);
  EXPECT_NEAR(area.at("long/top.1") + area.at("long/top.2"), (2.0 - 0.15) * 0.15, 1e-7);
  EXPECT_NEAR(area.at("short/bottom.1"), 0.275 * 0.15, 1e-7);  // numbered from where the beam begins
  EXPECT_NEAR(area.at("short/bottom.2"), 0.575 * 0.15, 1e-7);
}

TEST(Cover, DropsAFaceThatIsCoveredAsAWhole) {
  const Truss truss =
      build({"", {{"a", {0, 0, 0}, {1, 0, 0}, 0.2, 0.2, {0, 0, 1}}, {"b", {1, 0, 0}, {2, 0, 0}, 0.2, 0.2, {0, 0, 1}}}, {}});
  const auto area = areas(truss);
  EXPECT_EQ(truss.faces.size(), 10u);
  EXPECT_EQ(area.count("a/end") + area.count("b/begin"), 0u);
}

// A point of a box's surface is on one of its faces unless just above it there is another box.
TEST(Cover, KeepsJustThePointsThatNoOtherSolidCovers) {
  std::mt19937_64 random(7);
  const auto vector = [&](double size) {
    return Vector3d(uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size));
  };
  int covered = 0;
  for (int round = 0; round < 40; ++round) {
    Layout layout;
    for (int k = 0; k < 6; ++k) {
      const Vector3d from = vector(0.5);
      layout.beams.push_back({std::string(1, static_cast<char>('a' + k)), from, from + vector(1.0), uniform(random, 0.1, 0.5),
                              uniform(random, 0.1, 0.5), vector(1.0)});
    }
    const Truss truss = build(layout);
    for (int trial = 0; trial < 500; ++trial) {
      const auto s = static_cast<std::size_t>(random() % 6);
      const Solid& solid = truss.solids[s];
      const auto axis = static_cast<Eigen::Index>(random() % 3);
      Vector3d local(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
      local[axis] = local[axis] < 0.0 ? -1.0 : 1.0;
      Vector3d normal = Vector3d::Zero();
      normal[axis] = local[axis];
      const Vector3d point = solid.pose * solid.half.cwiseProduct(local);
      const Vector3d above = point + 1e-6 * (solid.pose.linear() * normal);
      double depth = -1e9;  // how deep the point above is inside another box
      for (std::size_t o = 0; o < 6; ++o)
        if (o != s) {
          const Vector3d inside = truss.solids[o].half - (truss.solids[o].pose.inverse() * above).cwiseAbs();
          depth = std::max(depth, inside.minCoeff());
        }
      if (std::abs(depth) < 1e-6) continue;
      bool found = false;
      for (const Face& face : truss.faces) {
        const Vector3d in = face.frame.inverse() * point;
        found = found || (face.solid == static_cast<int>(s) && std::abs(in.z()) < 1e-9 &&
                          geometry::contains(geometry::Region{face.outline, face.holes}, in.head<2>()));
      }
      EXPECT_EQ(found, depth < 0.0) << "round " << round << " solid " << s << " depth " << depth;
      covered += depth > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(covered, 1000);
}

}  // namespace
}  // namespace foothold::truss
