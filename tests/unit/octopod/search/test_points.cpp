// The paper's points P_A and P_B, with and without stability (its figures 6 and 8).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lands.hpp"

namespace foothold::octopod {
namespace {

// tan of the steepest plane on which the pyramid of ten edges always holds the robot: friction times cos(18 deg). 20.83 deg.
const double kSteepest = std::atan(0.4 * std::cos(std::numbers::pi / 10.0));

// All eight feet on one plane steeper than that.
bool clings(const Ground& ground, State state) {
  const auto& feet = ground.standing(state).standing.feet;
  return std::all_of(feet.begin(), feet.end(), [&](const Footing& foot) {
    return (foot.normal - feet[0].normal).norm() < 1e-9 && std::acos(foot.normal.z()) > kSteepest;
  });
}

double steepest(const Ground& ground, const Route& route) {
  double out = 0.0;
  for (const State state : route.states) out = std::max(out, ground.slope(node_of(state)));
  return out;
}

double length(const Ground& ground, const Route& route) {
  double out = 0.0;
  for (std::size_t k = 1; k < route.states.size(); ++k)
    out += (ground.place(node_of(route.states[k])) - ground.place(node_of(route.states[k - 1]))).norm();
  return out;
}

class Points : public testing::TestWithParam<Vector3d> {};

TEST_P(Points, TheStablePathIsDearerAndTheOtherGoesWhereTheRobotSlips) {
  const Ground ground = ground_of(terrain::ramps());
  const State from = state_at(ground, kO);
  const int goal = ground.nearest_node(GetParam());
  RouteOptions careful;
  careful.steepest = steepest_held(0.4, 10);
  EXPECT_NEAR(careful.steepest, kSteepest, 1e-12);
  const Route stable = optimal_route(ground, from, goal, careful, {}, {});
  ASSERT_EQ(stable.end, Route::End::kFound) << stable.blocked;
  for (const State state : stable.states) {
    EXPECT_TRUE(ground.stable(state));
    EXPECT_FALSE(clings(ground, state));
  }
  EXPECT_LE(steepest(ground, stable), kSteepest);
  RouteOptions careless;
  careless.stability = false;
  const Route steep = optimal_route(ground, from, goal, careless, {}, {});
  ASSERT_EQ(steep.end, Route::End::kFound) << steep.blocked;
  EXPECT_GT(steepest(ground, steep), std::atan(0.4));
  EXPECT_FALSE(std::all_of(steep.states.begin(), steep.states.end(), [&](State state) { return ground.stable(state); }));
  EXPECT_LT(steep.cost, stable.cost);
  EXPECT_LT(length(ground, steep), length(ground, stable));
}

TEST_P(Points, ThePaperTakesTheSteepWayToo) {
  const Ground ground = ground_of(terrain::ramps());
  const State from = state_at(ground, kO);
  RouteOptions careless;
  careless.stability = false;
  const Route steep = paper_route(ground, from, ground.nearest_node(GetParam()), careless, {});
  ASSERT_EQ(steep.end, Route::End::kFound);
  EXPECT_GT(steepest(ground, steep), std::atan(0.4));
  EXPECT_EQ(steep.penalised, 0);
  EXPECT_FALSE(std::all_of(steep.states.begin(), steep.states.end(), [&](State state) { return ground.stable(state); }));
}

INSTANTIATE_TEST_SUITE_P(OfThePaper, Points, testing::Values(kA, kB),
                         [](const auto& point) { return point.index == 0 ? "A" : "B"; });

}  // namespace
}  // namespace foothold::octopod
