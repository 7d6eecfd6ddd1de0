// What the searches over a terrain give back, and the three of them: the paper's, the proved one, and RRT*.
#pragma once

#include <functional>
#include <numbers>
#include <random>
#include <stop_token>
#include <string>
#include <vector>

#include "octopod/search/ground.hpp"

namespace foothold::octopod {

struct RouteOptions {
  bool stability = true;  // unstable states are forbidden; else they are as good as others
  // rad, with stability: steeper nodes are forbidden, too, though the robot may stand over a narrow one with its feet braced
  // across; in method paper they are as dear as
  // unstable ones.
  double steepest = std::numbers::pi;
  ChangeWeights weights;
  double posture_weight = 1.0;  // of q beside d
  long max_states = 100'000'000;
  long samples = 5'000;  // of method rrt
  double budget = 60.0;  // s, of method rrt: a run that it ends does not repeat itself
};

// May a route go through a state?
bool allowed(const Ground& ground, State state, const RouteOptions& options);
// The steepest plane on which the friction cone (0 edges: circular) always holds the robot, rad: with a pyramid, whichever way it
// is turned.
double steepest_held(double friction, int cone_edges);

// May the robot go from one state to the next? Asked when an edge is about to be used; its answers are kept by who gives them.
using Edge = std::function<bool(State from, State to)>;

struct Route {
  enum class End { kFound, kNoPath, kStopped, kExhausted };
  End end = End::kNoPath;
  std::vector<State> states;       // from start to goal
  std::vector<double> costs;       // up to each state, m
  double cost = 0.0, bound = 0.0;  // m; proved: no route costs less
  bool optimal = false;
  long expanded = 0, postures = 0;  // states expanded; postures made for this search
  int penalised = 0;                // of method paper: unstable states that it went through: if any, this is no way to go
  std::string blocked;              // of kNoPath: what is in the way, for people
  std::vector<State> cut;           // of kNoPath: the states that no route can pass, nearest to the goal first
};

// A* over (node, orientation) along Ground::adjacent(): least sum of d + posture_weight q, proved; unstable states forbidden. An
// empty `edge` allows all. The same request gives the same route. kExhausted after max_states were expanded, kStopped within a
// posture's time: `bound` is then what was proved so far.
Route optimal_route(const Ground& ground, State from, int goal_node, const RouteOptions& options, const Edge& edge,
                    const std::stop_token& stop);
// The paper's: A* over nodes, ten neighbours, of four orientations the one of least q + e, e = 1e12 for unstable ones. `cost` and
// `costs` are without e. `bound` is what the straight line costs.
Route paper_route(const Ground& ground, State from, int goal_node, const RouteOptions& options, const std::stop_token& stop);
// RRT* of OMPL along the same edges, with the same postures and verdicts, through all its samples. It cannot know that there is no
// way: kExhausted if it found none. `bound` is what the straight line costs; `expanded` counts samples.
Route rrt_route(const Ground& ground, State from, int goal_node, const RouteOptions& options, std::mt19937_64& random,
                const std::stop_token& stop, const Edge& edge = {});

// d + posture_weight q of one step, m. Both states stand.
double step_cost(const Ground& ground, State from, State to, const RouteOptions& options);

}  // namespace foothold::octopod
