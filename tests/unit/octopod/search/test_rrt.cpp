// RRT* over the same edges: sound, never better than the proved search, the same again from the same seed.
#include <gtest/gtest.h>

#include <algorithm>

#include "lands.hpp"

namespace foothold::octopod {
namespace {

TEST(Rrt, FindsASoundRouteThatCostsNoLessThanTheProvedOne) {
  const Ground ground = ground_of(terrain::ramps());
  const State from = state_at(ground, kO);
  const int goal = ground.nearest_node(kA);
  const Route proved = optimal_route(ground, from, goal, {}, {}, {});
  std::mt19937_64 random(3);
  const Route route = rrt_route(ground, from, goal, {}, random, {});
  ASSERT_EQ(route.end, Route::End::kFound);
  EXPECT_GE(route.cost, proved.cost - 1e-9);
  EXPECT_FALSE(route.optimal);
  EXPECT_EQ(route.states.front(), from);
  EXPECT_EQ(node_of(route.states.back()), goal);
  for (std::size_t k = 1; k < route.states.size(); ++k) {
    const auto beside = ground.adjacent(node_of(route.states[k - 1]));
    EXPECT_TRUE(std::binary_search(beside.begin(), beside.end(), node_of(route.states[k])));
    EXPECT_TRUE(ground.stable(route.states[k]));
    EXPECT_NEAR(route.costs[k] - route.costs[k - 1], step_cost(ground, route.states[k - 1], route.states[k], {}), 1e-9);
  }
}

TEST(Rrt, RepeatsItselfFromTheSameSeed) {
  const Ground ground = ground_of(terrain::ramps());
  const State from = state_at(ground, kO);
  std::mt19937_64 first(7), second(7), third(8);
  RouteOptions few;
  few.samples = 1500;
  const Route a = rrt_route(ground, from, ground.nearest_node(kA), few, first, {});
  const Route b = rrt_route(ground, from, ground.nearest_node(kA), few, second, {});
  const Route c = rrt_route(ground, from, ground.nearest_node(kA), few, third, {});
  ASSERT_EQ(a.end, Route::End::kFound);
  EXPECT_EQ(a.states, b.states);
  EXPECT_EQ(a.costs, b.costs);
  EXPECT_NE(a.states, c.states);
}

TEST(Rrt, UsesNoShutEdgeAndGivesUpWhereThereIsNoWay) {
  const Ground ground = ground_of(terrain::ramps());
  const State from = state_at(ground, kO);
  std::mt19937_64 random(1);
  RouteOptions few;
  few.samples = 2000;
  const Route none = rrt_route(ground, from, ground.nearest_node(kA), few, random, {}, [](State, State) { return false; });
  EXPECT_EQ(none.end, Route::End::kExhausted);
  EXPECT_TRUE(none.states.empty());
  const Edge even = [](State a, State b) { return (a + b) % 3 != 0; };
  const Route route = rrt_route(ground, from, ground.nearest_node(kA), {}, random, {}, even);
  ASSERT_EQ(route.end, Route::End::kFound);
  for (std::size_t k = 1; k < route.states.size(); ++k) EXPECT_TRUE(even(route.states[k - 1], route.states[k]));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(rrt_route(ground, from, ground.nearest_node(kA), {}, random, stop.get_token()).end, Route::End::kStopped);
}

}  // namespace
}  // namespace foothold::octopod
