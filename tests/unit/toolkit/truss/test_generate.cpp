// Generated trusses: the number asked for, valid files, connected, the same from the same seed.
#include <gtest/gtest.h>

#include <numeric>

#include "truss/generate.hpp"

namespace foothold::truss {
namespace {

constexpr Family kFamilies[] = {Family::kPortal, Family::kTower, Family::kBridge};

// Whether two boxes overlap or touch: no axis parts them.
bool overlap(const Solid& a, const Solid& b) {
  const Eigen::Matrix3d &A = a.pose.linear(), &B = b.pose.linear();
  const Vector3d way = b.pose.translation() - a.pose.translation();
  const auto parts = [&](const Vector3d& axis) {
    if (axis.norm() < 1e-9) return false;
    const double reach = (A.transpose() * axis).cwiseAbs().dot(a.half) + (B.transpose() * axis).cwiseAbs().dot(b.half);
    return std::abs(way.dot(axis)) > reach + 1e-9;
  };
  for (int i = 0; i < 3; ++i) {
    if (parts(A.col(i)) || parts(B.col(i))) return false;
    for (int j = 0; j < 3; ++j)
      if (parts(A.col(i).cross(B.col(j)))) return false;
  }
  return true;
}

bool connected(const Truss& truss) {
  std::vector<std::size_t> seen{0}, left(truss.solids.size() - 1);
  std::iota(left.begin(), left.end(), std::size_t{1});
  for (std::size_t k = 0; k < seen.size(); ++k)
    std::erase_if(left, [&](std::size_t other) {
      if (!overlap(truss.solids[seen[k]], truss.solids[other])) return false;
      seen.push_back(other);
      return true;
    });
  return left.empty();
}

TEST(Generate, MakesThreeHundredValidConnectedTrusses) {
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    for (const Family family : kFamilies) {
      const int beams = 2 + static_cast<int>((seed * seed * 7) % 80);
      const Layout layout = generate(family, seed, beams);
      ASSERT_EQ(layout.beams.size(), static_cast<std::size_t>(beams));
      for (const Beam& beam : layout.beams) {
        EXPECT_GE(std::min(beam.width, beam.height), 0.12);
        EXPECT_LE(std::max(beam.width, beam.height), 0.30);
        EXPECT_GT((beam.to - beam.from).norm(), 0.8);
      }
      const Truss truss = parse_truss(to_yaml(layout));
      EXPECT_GE(truss.faces.size(), layout.beams.size());
      EXPECT_TRUE(connected(truss)) << layout.description;
    }
}

TEST(Generate, MakesAsManyBeamsAsAskedFor) {
  for (const Family family : kFamilies) {
    for (int beams = kFewestBeams; beams < 60; ++beams)
      EXPECT_EQ(generate(family, 5, beams).beams.size(), static_cast<std::size_t>(beams));
    EXPECT_EQ(generate(family, 5, kMostBeams).beams.size(), static_cast<std::size_t>(kMostBeams));
    EXPECT_THROW(generate(family, 5, 1), std::invalid_argument);
    EXPECT_THROW(generate(family, 5, 2001), std::invalid_argument);
  }
}

TEST(Generate, GivesTheSameBytesForTheSameSeedAndOthersForAnother) {
  for (const Family family : kFamilies) {
    EXPECT_EQ(to_yaml(generate(family, 11, 30)), to_yaml(generate(family, 11, 30)));
    EXPECT_NE(to_yaml(generate(family, 11, 30)), to_yaml(generate(family, 12, 30)));
  }
}

// Bytes as first written, so that another machine or library that draws otherwise is noticed.
TEST(Generate, DrawsOnThisMachineAsOnTheFirst) {
  EXPECT_EQ(to_yaml(generate(Family::kBridge, 1, 2)),
            "kind: truss\ndescription: \"bridge bays of 2 beams, seed 1\"\nbeams:\n"
            "  - {name: \"chord 1-1\", from: [0, 0, 0], to: [1.211, 0, 0], profile: {width: 0.275, height: 0.275}, up: [0, 0, 1]}\n"
            "  - {name: \"post 1-1\", from: [0, 0, 0], to: [0, 0, 1.993], profile: {width: 0.22, height: 0.22}, up: [1, 0, 0]}\n");
}

TEST(Generate, KnowsItsFamiliesByName) {
  EXPECT_EQ(family_named("portal"), Family::kPortal);
  EXPECT_EQ(family_named("tower"), Family::kTower);
  EXPECT_EQ(family_named("bridge"), Family::kBridge);
  EXPECT_FALSE(family_named("arch").has_value());
}

}  // namespace
}  // namespace foothold::truss
