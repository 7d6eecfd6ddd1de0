// What stands in the way when there is none: the cut separates, and says what it lacks.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "lands.hpp"

namespace foothold::octopod {
namespace {

Ground slippery_ramps() {
  GroundOptions options;
  options.friction = 0.3;  // 16.7 deg: the third ramp is too steep
  return ground_of(terrain::ramps(), options);
}

TEST(Cut, SeparatesStartAndGoal) {
  const Ground ground = slippery_ramps();
  const State from = state_at(ground, kO);
  const int goal = ground.nearest_node(Vector3d(-0.9, -0.9, 0.4));
  const Route none = optimal_route(ground, from, goal, {}, {}, {});
  ASSERT_EQ(none.end, Route::End::kNoPath);
  ASSERT_FALSE(none.cut.empty());
  for (const State state : none.cut) EXPECT_FALSE(ground.stable(state));
  RouteOptions careless;
  careless.stability = false;
  EXPECT_EQ(optimal_route(ground, from, goal, careless, {}, {}).end, Route::End::kFound);
  const std::set<State> cut(none.cut.begin(), none.cut.end());
  const Edge round_it = [&](State, State to) { return !cut.contains(to); };
  EXPECT_EQ(optimal_route(ground, from, goal, careless, round_it, {}).end, Route::End::kNoPath);
}

TEST(Cut, NamesTheNearestToTheGoalFirstAndWhatItLacks) {
  const Ground ground = slippery_ramps();
  const State from = state_at(ground, kO);
  const int goal = ground.nearest_node(Vector3d(-0.9, -0.9, 0.4));
  const Route none = optimal_route(ground, from, goal, {}, {}, {});
  ASSERT_EQ(none.end, Route::End::kNoPath);
  const auto far = [&](State state) { return (ground.place(node_of(state)) - ground.place(goal)).norm(); };
  EXPECT_TRUE(std::is_sorted(none.cut.begin(), none.cut.end(), [&](State a, State b) { return far(a) < far(b); }));
  EXPECT_NE(none.blocked.find("needs friction 0."), std::string::npos) << none.blocked;
  EXPECT_NE(none.blocked.find("has 0.30"), std::string::npos) << none.blocked;
  EXPECT_NE(none.blocked.find("slope"), std::string::npos) << none.blocked;
}

TEST(Cut, IsTheGoalWhereTheRobotCannotStandThere) {
  const Ground ground = slippery_ramps();
  const State from = state_at(ground, kO);
  int steep = -1;
  for (int node = 0; node < ground.nodes() && steep < 0; ++node) {
    bool none = true;
    for (int k = 0; k < kOrientations; ++k) none = none && !ground.stable(kOrientations * node + k);
    if (none) steep = node;
  }
  ASSERT_GE(steep, 0);
  const Route to = optimal_route(ground, from, steep, {}, {}, {});
  ASSERT_EQ(to.end, Route::End::kNoPath);
  EXPECT_EQ(to.cut.size(), static_cast<std::size_t>(kOrientations));
  EXPECT_EQ(node_of(to.cut.front()), steep);
  EXPECT_TRUE(to.blocked.starts_with("the goal itself")) << to.blocked;
  const Route out = optimal_route(ground, kOrientations * steep, node_of(from), {}, {}, {});
  ASSERT_EQ(out.end, Route::End::kNoPath);
  EXPECT_TRUE(out.blocked.starts_with("the start itself")) << out.blocked;
}

TEST(Cut, TellsOfStatesToWhichNoTransitionLeads) {
  const Ground ground = ground_of(terrain::ramps());
  const State from = state_at(ground, kO);
  const Route none = optimal_route(ground, from, ground.nearest_node(kA), {}, [](State, State) { return false; }, {});
  ASSERT_EQ(none.end, Route::End::kNoPath);
  EXPECT_NE(none.blocked.find("no transition"), std::string::npos) << none.blocked;
}

TEST(Cut, IsEmptyWhereTheTerrainIsInPieces) {
  mesh::TriangleMesh two;
  two.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {20, 0, 0}, {21, 0, 0}, {21, 1, 0}, {20, 1, 0}};
  two.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const Ground ground = ground_of(terrain::make_terrain(mesh::joined(two.vertices, two.triangles)));
  const State from = state_at(ground, {0.5, 0.5, 0.0});
  ASSERT_TRUE(ground.stable(from));
  const Route none = optimal_route(ground, from, ground.nearest_node({20.5, 0.5, 0.0}), {}, {}, {});
  ASSERT_EQ(none.end, Route::End::kNoPath);
  EXPECT_TRUE(none.cut.empty());
  EXPECT_EQ(none.blocked, "the terrain under start and goal is not connected");
}

}  // namespace
}  // namespace foothold::octopod
