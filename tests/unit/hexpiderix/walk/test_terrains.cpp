// Walks over generated terrains: boulders made low, stairs, a ditch; each half cycle before the judge. 200 with FOOTHOLD_LONG=1,
// else a share of them.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <sstream>

#include "../grounds.hpp"
#include "judged.hpp"
#include "terrain/generate.hpp"

namespace foothold::hexpiderix::testing {
namespace {

// The same terrain with its heights times `share`.
terrain::Terrain flattened(const terrain::Terrain& from, double share) {
  std::vector<Vector3d> vertices = from.vertices;
  for (Vector3d& v : vertices) v.z() *= share;
  return terrain::make_terrain(mesh::joined(vertices, from.triangles));
}

struct Country {
  const char* name;
  terrain::Family family;
  double share;     // of its heights
  int whole;        // walks with FOOTHOLD_LONG=1
  double arriving;  // share of those that begin, at least
};

void PrintTo(const Country& country, std::ostream* out) { *out << country.name; }

class Countries : public ::testing::TestWithParam<Country> {};

TEST_P(Countries, AreWalkedOverOrItIsSaidWhyNot) {
  const Country& country = GetParam();
  const int count = std::getenv("FOOTHOLD_LONG") != nullptr ? country.whole : country.whole / 12;
  int arrived = 0, begun = 0, blocked = 0;
  double most = 0.0;
  for (int seed = 1; seed <= count; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    std::uniform_real_distribution<double> side(-1.0, 1.0);
    const Ground ground(flattened(terrain::generate(country.family, {static_cast<std::uint64_t>(seed), 4.0, 0.16}), country.share));
    WalkOptions options;
    options.least_nesm = 3e-3;
    const auto from = stand_at(shipped_model(), ground, {on(ground, -1.0, side(random)), side(random)}, options);
    if (!from) continue;
    const Station goal{on(ground, 1.0, side(random)), side(random)};
    if (!stand_at(shipped_model(), ground, goal, options)) continue;
    ++begun;
    const Walk found = walk(shipped_model(), ground, *from, goal, options, {});
    most = std::max(most, static_cast<double>(found.tried));
    if (found.end == Walk::End::kArrived) {
      ++arrived;
      expect_sound(ground, *from, found, options);
      EXPECT_NEAR((found.half_cycles.back().to.at.thorax.translation() - goal.place).head<2>().norm(), 0.0, 0.15);
    } else {
      ++blocked;
      EXPECT_EQ(found.end, Walk::End::kBlocked);
      EXPECT_FALSE(found.because.empty());
      std::printf("seed %d, blocked at (%.2f, %.2f): %s\n", seed, found.farthest.x(), found.farthest.y(), found.because.c_str());
    }
  }
  std::printf("%s: of %d walks %d can begin, %d arrive, %d are blocked; most half cycles tried %.0f\n", country.name, count, begun,
              arrived, blocked, most);
  EXPECT_GE(begun, count / 2);
  EXPECT_GE(arrived, country.arriving * begun);
}

INSTANTIATE_TEST_SUITE_P(Each, Countries,
                         ::testing::Values(Country{"LowBoulders", terrain::Family::kBoulders, 0.15, 80, 0.9},
                                           Country{"Stairs", terrain::Family::kStairs, 0.5, 60, 0.7},
                                           Country{"Ditch", terrain::Family::kDitch, 0.3, 60, 0.7}),
                         [](const auto& tested) { return std::string(tested.param.name); });

// Level ground with a block on it, 0.4 m high, from (-0.15, -half) to (0.15, half).
std::string with_block(double half) {
  std::ostringstream out;
  out << "kind: terrain\nvertices: [[-2, -2, 0], [2, -2, 0], [2, 2, 0], [-2, 2, 0]";
  for (const double z : {-0.1, 0.4})
    for (const auto& [x, y] : {std::pair{-0.15, -half}, {0.15, -half}, {0.15, half}, {-0.15, half}})
      out << ", [" << x << ", " << y << ", " << z << "]";
  out << "]\ntriangles: [[0, 1, 2], [0, 2, 3], [8, 9, 10], [8, 10, 11], [4, 6, 5], [4, 7, 6]";
  for (int k = 0; k < 4; ++k) {
    const int a = 4 + k, b = 4 + (k + 1) % 4;
    out << ", [" << a << ", " << b << ", " << b + 4 << "], [" << a << ", " << b + 4 << ", " << a + 4 << "]";
  }
  out << "]\n";
  return out.str();
}

TEST(Detour, LeadsRoundABlockThatCannotBeWalkedOver) {
  const Ground ground(terrain::parse_terrain(with_block(0.5)));
  const WalkOptions options;
  const auto from = stand_at(shipped_model(), ground, {on(ground, -1, 0), 0.0}, options);
  ASSERT_TRUE(from);
  const Walk found = walk(shipped_model(), ground, *from, {on(ground, 1, 0.1), 0.5}, options, {});
  ASSERT_EQ(found.end, Walk::End::kArrived) << found.because;
  expect_sound(ground, *from, found, options);
  double widest = 0.0;
  for (const HalfCycle& half : found.half_cycles) widest = std::max(widest, std::abs(half.to.at.thorax.translation().y()));
  EXPECT_GT(widest, 0.5);
  EXPECT_LT(widest, 1.0) << "not farther round than it takes";
}

TEST(Detour, ThereIsNoneRoundABlockAcrossTheWholeGround) {
  const Ground ground(terrain::parse_terrain(with_block(1.99)));
  const WalkOptions options;
  const auto from = stand_at(shipped_model(), ground, {on(ground, -1, 0), 0.0}, options);
  ASSERT_TRUE(from);
  const Walk found = walk(shipped_model(), ground, *from, {on(ground, 1, 0), 0.0}, options, {});
  EXPECT_EQ(found.end, Walk::End::kBlocked);
  EXPECT_FALSE(found.because.empty());
  EXPECT_TRUE(found.half_cycles.empty());
  EXPECT_LT(found.farthest.x(), 0.0) << "the try ended in front of it";
}

}  // namespace
}  // namespace foothold::hexpiderix::testing
