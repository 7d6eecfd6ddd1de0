// The proved search against exhaustive search, and what it owes its callers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "exhaustive.hpp"
#include "lands.hpp"

namespace foothold::octopod {
namespace {

constexpr double kSame = 1e-9;

// Some edges are shut, always the same ones, as if there were no transition.
bool some_edges(State a, State b) {
  const auto mixed = static_cast<std::uint64_t>(a) * 0x9E3779B97F4A7C15ULL + static_cast<std::uint64_t>(b) * 0xC2B2AE3D27D4EB4FULL;
  return (mixed >> 40U) % 3 != 0;
}

void expect_sound(const Ground& ground, const Route& route, State from, int goal, const RouteOptions& options) {
  ASSERT_EQ(route.end, Route::End::kFound);
  ASSERT_EQ(route.states.size(), route.costs.size());
  EXPECT_EQ(route.states.front(), from);
  EXPECT_EQ(node_of(route.states.back()), goal);
  double cost = 0.0;
  for (std::size_t k = 0; k < route.states.size(); ++k) {
    if (k > 0) {
      const auto beside = ground.adjacent(node_of(route.states[k - 1]));
      EXPECT_TRUE(std::binary_search(beside.begin(), beside.end(), node_of(route.states[k])));
      cost += step_cost(ground, route.states[k - 1], route.states[k], options);
    }
    EXPECT_NEAR(route.costs[k], cost, kSame);
    EXPECT_TRUE(options.stability ? ground.stable(route.states[k]) : ground.stands(route.states[k]));
  }
  EXPECT_NEAR(route.cost, cost, kSame);
}

struct Case {
  terrain::Family family;
  double size, resolution;
};

Ground ground_of_case(const Case& c, std::uint64_t seed) {
  terrain::Options options;
  options.seed = seed;
  options.size = c.size;
  GroundOptions how;
  how.resolution = c.resolution;
  return ground_of(terrain::generate(c.family, options), how);
}

TEST(Optimal, CostsWhatExhaustiveSearchFinds) {
  const Case cases[] = {{terrain::Family::kBoulders, 1.5, 0.2},
                        {terrain::Family::kStairs, 2.0, 0.3},
                        {terrain::Family::kDitch, 2.0, 0.2},
                        {terrain::Family::kRamps, 2.0, 0.3}};
  std::mt19937_64 random(1);
  int found = 0, none = 0;
  for (const Case& c : cases)
    for (int variant = 0; variant < (long_tests() ? 12 : 2); ++variant) {
      const Ground ground = ground_of_case(c, static_cast<std::uint64_t>(variant) + 1);
      RouteOptions options;
      options.stability = variant % 3 != 2;
      options.posture_weight = variant % 2 == 0 ? 1.0 : 0.3;
      const Edge edge = variant % 2 == 0 ? Edge{} : Edge{some_edges};
      const State from = stable_state(ground, static_cast<int>(random() % static_cast<std::uint64_t>(ground.nodes())));
      const std::vector<double> least = least_costs(ground, from, options, edge);
      for (int k = 0; k < 25; ++k) {
        const int goal = static_cast<int>(random() % static_cast<std::uint64_t>(ground.nodes()));
        const auto first = least.begin() + kOrientations * goal;
        const double expected = *std::min_element(first, first + kOrientations);
        ground.forget();
        const Route route = optimal_route(ground, from, goal, options, edge, {});
        if (std::isinf(expected)) {
          ++none;
          EXPECT_EQ(route.end, Route::End::kNoPath);
          EXPECT_FALSE(route.blocked.empty());
          continue;
        }
        ++found;
        expect_sound(ground, route, from, goal, options);
        EXPECT_TRUE(route.optimal);
        EXPECT_NEAR(route.cost, expected, kSame) << "goal " << goal << " variant " << variant;
        EXPECT_EQ(route.bound, route.cost);
      }
    }
  EXPECT_GT(found, 50);
  EXPECT_GT(none, 5);
}

TEST(Optimal, GivesTheSameRouteAgainWhateverIsKept) {
  const Ground ground = ground_of(terrain::ramps());
  const State from = state_at(ground, kO);
  ground.forget();
  const Route cold = optimal_route(ground, from, ground.nearest_node(kA), {}, {}, {});
  EXPECT_GT(cold.postures, 0);
  const Route kept = optimal_route(ground, from, ground.nearest_node(kA), {}, {}, {});
  EXPECT_EQ(kept.postures, 0);
  EXPECT_EQ(kept.states, cold.states);
  EXPECT_EQ(kept.costs, cold.costs);
  EXPECT_EQ(kept.expanded, cold.expanded);
  optimal_route(ground, from, ground.nearest_node(kB), {}, {}, {});
  ground.forget();
  const Route again = optimal_route(ground, from, ground.nearest_node(kA), {}, {}, {});
  EXPECT_EQ(again.states, cold.states);
  EXPECT_EQ(again.costs, cold.costs);
  EXPECT_EQ(again.postures, cold.postures);
}

TEST(Optimal, ProvesABoundWhenItsStatesRunOutOrItIsStopped) {
  const Ground ground = ground_of(terrain::ramps());
  const State from = state_at(ground, kO);
  const int goal = ground.nearest_node(kA);
  const Route whole = optimal_route(ground, from, goal, {}, {}, {});
  ASSERT_EQ(whole.end, Route::End::kFound);
  double before = 0.0;
  for (const long states : {0L, 1L, whole.expanded / 8, whole.expanded / 2, whole.expanded - 1}) {
    RouteOptions options;
    options.max_states = states;
    const Route part = optimal_route(ground, from, goal, options, {}, {});
    EXPECT_EQ(part.end, Route::End::kExhausted);
    EXPECT_EQ(part.expanded, states);
    EXPECT_FALSE(part.optimal);
    EXPECT_TRUE(part.states.empty());
    EXPECT_GE(part.bound, before - kSame);
    EXPECT_LE(part.bound, whole.cost + kSame);
    before = part.bound;
  }
  EXPECT_GT(before, 0.9 * whole.cost);
  std::stop_source stop;
  stop.request_stop();
  const Route stopped = optimal_route(ground, from, goal, {}, {}, stop.get_token());
  EXPECT_EQ(stopped.end, Route::End::kStopped);
  EXPECT_GT(stopped.bound, (ground.place(goal) - ground.place(node_of(from))).norm() - kSame);
}

TEST(Optimal, AsksForAnEdgeOnlyWhenItIsAboutToBeUsed) {
  const Ground ground = ground_of(terrain::ramps());
  const State from = state_at(ground, kO);
  long asked = 0;
  std::set<std::pair<State, State>> pairs;
  const Edge edge = [&](State a, State b) {
    ++asked;
    pairs.emplace(a, b);
    return some_edges(a, b);
  };
  const Route route = optimal_route(ground, from, ground.nearest_node(kA), {}, edge, {});
  ASSERT_EQ(route.end, Route::End::kFound);
  EXPECT_EQ(static_cast<std::size_t>(asked), pairs.size());
  // A third is shut, so half as many again as states are closed, not the dozens of edges that each state has.
  EXPECT_LT(asked, 2 * route.expanded);
  for (std::size_t k = 1; k < route.states.size(); ++k) EXPECT_TRUE(pairs.contains({route.states[k - 1], route.states[k]}));
}

TEST(Optimal, IsThereWhenItBegins) {
  const Ground ground = ground_of(terrain::ramps());
  const State from = state_at(ground, kO);
  const Route route = optimal_route(ground, from, node_of(from), {}, {}, {});
  expect_sound(ground, route, from, node_of(from), {});
  EXPECT_EQ(route.cost, 0.0);
}

}  // namespace
}  // namespace foothold::octopod
