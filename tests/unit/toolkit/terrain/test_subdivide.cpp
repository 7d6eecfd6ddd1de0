// Finer terrains are the same surface; their adjacency is right, whatever hangs on a side.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "foothold/errors.hpp"
#include "terrains.hpp"

namespace foothold::terrain {
namespace {

constexpr Split kSplits[] = {Split::kMidpoint, Split::kSlivers, Split::kLongestSide};

// A floor with one sliver on it: the highest of its corners is near the others' line.
Terrain with_sliver() {
  return make_terrain(
      mesh::joined({{0, 0, 0}, {2, 0, 0}, {1, 0.05, 0}, {1, 1, 0}, {1, -1, 0}}, {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {1, 0, 4}}));
}

// Whether the segments lie on one line and have more than a point in common.
bool overlap(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  const double length = (b - a).norm();
  const Vector3d along = (b - a) / length;
  for (const Vector3d& p : {c, d})
    if ((p - a).cross(along).norm() > 1e-9) return false;
  const double s = along.dot(c - a), t = along.dot(d - a);
  return std::min(length, std::max(s, t)) - std::max(0.0, std::min(s, t)) > 1e-9;
}

std::set<int> neighbours_by_all_pairs(const Terrain& terrain, int t) {
  std::set<int> out;
  for (int other = 0; other < static_cast<int>(terrain.size()); ++other)
    for (int i = 0; i < 3 && other != t; ++i)
      for (int j = 0; j < 3; ++j)
        if (overlap(terrain.corner(t, i), terrain.corner(t, (i + 1) % 3), terrain.corner(other, j),
                    terrain.corner(other, (j + 1) % 3)))
          out.insert(other);
  return out;
}

TEST(Subdivide, ReachesTheBoundAndKeepsTheSurface) {
  for (const Terrain& whole : some_terrains())
    for (const Split split : kSplits)
      for (const double bound : {1.0, 0.2, 0.07}) {
        const Terrain fine = subdivide(whole, bound, split);
        std::vector<double> left;
        for (int t = 0; t < static_cast<int>(whole.size()); ++t) left.push_back(area(whole, t));
        int last = 0;
        for (int t = 0; t < static_cast<int>(fine.size()); ++t) {
          const auto k = static_cast<std::size_t>(t);
          const int origin = fine.origins[k];
          const auto from = static_cast<std::size_t>(origin);
          EXPECT_LT(circumradius(fine, t), bound);
          EXPECT_LE(last, origin);
          last = origin;
          left[from] -= area(fine, t);
          EXPECT_EQ(fine.ground[k], whole.ground[from]);
          EXPECT_NEAR((fine.normals[k] - whole.normals[from]).norm(), 0.0, 1e-9);
          for (int c = 0; c < 3; ++c)  // in the plane of its origin, and inside it
            EXPECT_LT(
                (nearest_on_triangle(fine.corner(t, c), whole.corner(origin, 0), whole.corner(origin, 1), whole.corner(origin, 2)) -
                 fine.corner(t, c))
                    .norm(),
                1e-12);
        }
        for (const double rest : left) EXPECT_NEAR(rest, 0.0, 1e-9);
      }
}

TEST(Subdivide, LeavesAloneWhatIsFineEnough) {
  const Terrain whole = ramps();
  for (const Split split : kSplits) EXPECT_EQ(subdivide(whole, 10.0, split).triangles, whole.triangles);
}

TEST(Subdivide, TellsTheSameNeighboursAsAllPairsOfSides) {
  std::vector<Terrain> terrains{ramps(), with_sliver()};
  for (const Terrain& whole : terrains)
    for (const Split split : kSplits)
      for (const double bound : {5.0, 0.4}) {
        const Terrain fine = subdivide(whole, bound, split);
        for (int t = 0; t < static_cast<int>(fine.size()); ++t) {
          const auto told = fine.neighbours(t);
          EXPECT_EQ(std::set<int>(told.begin(), told.end()), neighbours_by_all_pairs(fine, t)) << "triangle " << t;
          EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
        }
      }
}

TEST(Subdivide, ByTheLongestSideLeavesNoVertexHanging) {
  for (const Terrain& whole : {ramps(), with_sliver()}) {
    const Terrain fine = subdivide(whole, 0.1, Split::kLongestSide);
    double border = 0.0, border_before = 0.0;
    const auto sum_borders = [](const Terrain& terrain) {
      double out = 0.0;
      for (int t = 0; t < static_cast<int>(terrain.size()); ++t)
        for (int c = 0; c < 3; ++c) {
          int shared = 0;
          for (const int n : terrain.neighbours(t))
            for (int j = 0; j < 3; ++j)
              shared +=
                  terrain.corner(n, j) == terrain.corner(t, (c + 1) % 3) && terrain.corner(n, (j + 1) % 3) == terrain.corner(t, c)
                      ? 1
                      : 0;
          EXPECT_LE(shared, 1);
          if (shared == 0) out += (terrain.corner(t, c) - terrain.corner(t, (c + 1) % 3)).norm();
        }
      return out;
    };
    border = sum_borders(fine), border_before = sum_borders(whole);
    EXPECT_NEAR(border, border_before, 1e-9);  // a hanging vertex would make sides without a partner
  }
}

TEST(Subdivide, CutsASliverIntoFewerPiecesThanMidpointsDo) {
  const Terrain whole = with_sliver();
  const auto of_sliver = [&](Split split) {
    const Terrain fine = subdivide(whole, 0.2, split);
    return std::count(fine.origins.begin(), fine.origins.end(), 0);
  };
  EXPECT_EQ(of_sliver(Split::kMidpoint), 4096);  // circumradius 10 m: six times halved
  EXPECT_LT(of_sliver(Split::kSlivers), 64);
  EXPECT_LT(of_sliver(Split::kLongestSide), 64);
}

TEST(Subdivide, RefusesWhatHasNoEnd) {
  const Terrain whole = ramps();
  EXPECT_THROW(subdivide(whole, 0.0), std::invalid_argument);
  EXPECT_THROW(subdivide(whole, NAN), std::invalid_argument);
  for (const Split split : kSplits) {
    try {
      subdivide(whole, 0.2, split, 100);
      ADD_FAILURE();
    } catch (const InvalidScene& fault) {
      EXPECT_EQ(fault.field(), "triangles");
      EXPECT_NE(std::string(fault.what()).find("more than 100 "), std::string::npos) << fault.what();
    }
  }
  const Terrain needle = make_terrain(mesh::joined({{0, 0, 0}, {900, 0, 0}, {450, 2e-6, 0}}, {{0, 1, 2}}));
  try {
    subdivide(needle, 0.001);
    ADD_FAILURE();
  } catch (const InvalidScene& fault) {
    EXPECT_EQ(fault.field(), "triangles[0]");
    EXPECT_NE(std::string(fault.what()).find("sliver"), std::string::npos) << fault.what();
  }
}

}  // namespace
}  // namespace foothold::terrain
