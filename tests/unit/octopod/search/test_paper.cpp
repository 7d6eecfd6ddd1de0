// The paper's search beside the proved one: on the paper's own cost.
#include <gtest/gtest.h>

#include "lands.hpp"

namespace foothold::octopod {
namespace {

TEST(Paper, NeverCostsLessThanTheProvedSearch) {
  const Ground ground = ground_of(terrain::ramps());
  std::mt19937_64 random(6);
  const int pairs = long_tests() ? 500 : 60;
  int both = 0, dearer = 0;
  for (int k = 0; k < pairs; ++k) {
    const auto nodes = static_cast<std::uint64_t>(ground.nodes());
    const State from = stable_state(ground, static_cast<int>(random() % nodes));
    const int goal = static_cast<int>(random() % nodes);
    const Route paper = paper_route(ground, from, goal, {}, {});
    const Route proved = optimal_route(ground, from, goal, {}, {}, {});
    const bool way = paper.end == Route::End::kFound && paper.penalised == 0 && ground.stable(from);
    if (way) {
      ASSERT_EQ(proved.end, Route::End::kFound) << proved.blocked;
      EXPECT_LE(proved.cost, paper.cost + 1e-9);
      ++both;
      if (proved.cost < paper.cost - 1e-6) ++dearer;
    }
    if (proved.end == Route::End::kFound) {
      EXPECT_GE(proved.cost, paper.bound - 1e-9);
    }
  }
  EXPECT_GT(both, pairs / 5);
  EXPECT_GT(dearer, 0);  // keeping one orientation to a node costs something
}

TEST(Paper, TellsOfTheUnstableStatesThatItWentThrough) {
  GroundOptions slippery;
  slippery.friction = 0.3;  // 16.7 deg: the third ramp is too steep
  const Ground ground = ground_of(terrain::ramps(), slippery);
  const State from = state_at(ground, kO);
  const int goal = ground.nearest_node(kB);
  const Route paper = paper_route(ground, from, goal, {}, {});
  ASSERT_EQ(paper.end, Route::End::kFound);
  int unstable = 0;
  for (const State state : paper.states) unstable += ground.stable(state) ? 0 : 1;
  EXPECT_GT(paper.penalised, 0);
  EXPECT_EQ(paper.penalised, unstable);
  EXPECT_LT(paper.cost, 100.0);  // without the penalty
  EXPECT_EQ(optimal_route(ground, from, goal, {}, {}, {}).end, Route::End::kNoPath);
}

TEST(Paper, HeedsAStopAndItsLimit) {
  const Ground ground = ground_of(terrain::ramps());
  const State from = state_at(ground, kO);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(paper_route(ground, from, ground.nearest_node(kA), {}, stop.get_token()).end, Route::End::kStopped);
  RouteOptions options;
  options.max_states = 5;
  const Route part = paper_route(ground, from, ground.nearest_node(kA), options, {});
  EXPECT_EQ(part.end, Route::End::kExhausted);
  EXPECT_EQ(part.expanded, 5);
}

}  // namespace
}  // namespace foothold::octopod
