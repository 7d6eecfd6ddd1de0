// Nodes, their neighbours, and what the ground keeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lands.hpp"

namespace foothold::octopod {
namespace {

TEST(Ground, HasThePapersNumberOfNodes) {
  const Ground ground = ground_of(terrain::ramps());
  EXPECT_EQ(ground.surface().terrain().size(), 42U);
  EXPECT_EQ(ground.nodes(), static_cast<int>(terrain::subdivide(ground.surface().terrain(), 0.2).size()));
}

TEST(Ground, NearestNodesAreThoseThatBruteForceFinds) {
  const Ground ground = ground_of(terrain::generate(terrain::Family::kBoulders, {}));
  std::vector<int> all(static_cast<std::size_t>(ground.nodes()));
  for (int node = 0; node < ground.nodes(); node += 7) {
    const auto far = [&](int other) { return (ground.place(other) - ground.place(node)).norm(); };
    std::iota(all.begin(), all.end(), 0);
    std::partial_sort(all.begin(), all.begin() + 11, all.end(), [&](int a, int b) { return far(a) < far(b); });
    const auto nearest = ground.nearest(node);
    ASSERT_EQ(nearest.size(), 10U);
    EXPECT_EQ(std::find(nearest.begin(), nearest.end(), node), nearest.end());
    for (std::size_t k = 0; k < nearest.size(); ++k) EXPECT_NEAR(far(nearest[k]), far(all[k + 1]), 1e-12);
    EXPECT_EQ(ground.nearest_node(ground.place(node)), node);
  }
}

TEST(Ground, AdjacencyIsSymmetricAndHoldsTheNearestAndThoseAcrossEdges) {
  const Ground ground = ground_of(terrain::ramps());
  const terrain::Terrain fine = terrain::subdivide(ground.surface().terrain(), 0.2);
  ASSERT_EQ(static_cast<int>(fine.size()), ground.nodes());
  for (int node = 0; node < ground.nodes(); ++node) {
    const auto adjacent = ground.adjacent(node);
    EXPECT_TRUE(std::is_sorted(adjacent.begin(), adjacent.end()));
    EXPECT_EQ(std::adjacent_find(adjacent.begin(), adjacent.end()), adjacent.end());
    const auto holds = [](std::span<const int> list, int which) { return std::binary_search(list.begin(), list.end(), which); };
    EXPECT_FALSE(holds(adjacent, node));
    for (const int other : adjacent) EXPECT_TRUE(holds(ground.adjacent(other), node));
    for (const int other : ground.nearest(node)) EXPECT_TRUE(holds(adjacent, other));
    for (const int other : fine.neighbours(node)) EXPECT_TRUE(holds(adjacent, other));
  }
}

TEST(Ground, KeepsPosturesVerdictsAndPassagesUntilTheyAreForgotten) {
  const Ground ground = ground_of(terrain::ramps());
  const State state = state_at(ground, kO);
  const long made = ground.postures_made();
  const Built* first = &ground.standing(state);
  for (State other = 0; other < 400; ++other) ground.stable(other);
  EXPECT_EQ(&ground.standing(state), first);
  EXPECT_LE(ground.postures_made(), made + 200);  // opposite headings share one
  EXPECT_FALSE(ground.passage(state, 3));
  ground.keep_passage(state, 3, false);
  EXPECT_EQ(ground.passage(state, 3), std::optional(false));
  EXPECT_FALSE(ground.passage(3, state));
  ground.forget();
  EXPECT_FALSE(ground.passage(state, 3));
  const long before = ground.postures_made();
  ground.standing(state);
  EXPECT_EQ(ground.postures_made(), before + 1);
}

TEST(Ground, VerdictsAgreeWithCriticalFriction) {
  const Ground ground = ground_of(terrain::ramps());
  int stable = 0, unstable = 0;
  for (State state = 0; state < ground.states(); state += 5) {
    if (!ground.stands(state)) {
      EXPECT_FALSE(ground.stable(state));
      EXPECT_TRUE(std::isinf(ground.critical_friction(state)));
      continue;
    }
    const double critical = ground.critical_friction(state);
    if (std::abs(critical - 0.4) > 1e-6) {
      EXPECT_EQ(ground.stable(state), critical < 0.4) << state << " " << critical;
    }
    ++(ground.stable(state) ? stable : unstable);
  }
  EXPECT_GT(stable, 100);
  EXPECT_GT(unstable, 100);
}

TEST(Ground, AsPrintedStandsAndIsStableOnTheSameFloor) {
  GroundOptions printed;
  printed.as_printed = true;
  const Ground paper = ground_of(terrain::ramps(), printed), ours = ground_of(terrain::ramps());
  ASSERT_EQ(paper.nodes(), ours.nodes());
  int compared = 0;
  for (int node = 0; node < ours.nodes(); ++node) {
    if (ours.slope(node) > 1e-9 || ours.place(node).head<2>().norm() > 0.2) continue;
    for (int axis = 0; axis < kAxes; ++axis) {
      const State state = kOrientations * node + axis;
      if (!ours.stands(state) || !paper.stands(state)) continue;
      EXPECT_LT(paper.standing(state).standing.residual, 1e-9);
      EXPECT_EQ(paper.stable(state), ours.stable(state)) << state;
      ++compared;
    }
  }
  EXPECT_GT(compared, 10);
}

TEST(Ground, RefusesOptionsOutOfRange) {
  GroundOptions options;
  options.friction = -0.1;
  EXPECT_THROW(ground_of(terrain::ramps(), options), std::invalid_argument);
  options = {};
  options.neighbours = 0;
  EXPECT_THROW(ground_of(terrain::ramps(), options), std::invalid_argument);
  options = {};
  options.cone_edges = 2;
  EXPECT_THROW(ground_of(terrain::ramps(), options), std::invalid_argument);
  options = {};
  options.resolution = 0.0;
  EXPECT_THROW(ground_of(terrain::ramps(), options), std::invalid_argument);
}

}  // namespace
}  // namespace foothold::octopod
