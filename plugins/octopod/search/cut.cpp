// The cut between what a search reached and its goal, and its description for people.
#include "octopod/search/cut.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace foothold::octopod {
namespace {

constexpr std::size_t kDescribed = 3;  // places in the description

std::size_t index(State state) { return static_cast<std::size_t>(state); }

std::vector<State> states_of(int node) {
  std::vector<State> out;
  for (int k = 0; k < kOrientations; ++k) out.push_back(kOrientations * node + k);
  return out;
}

std::string format(const char* pattern, auto... values) {
  char text[160];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

// The state of the node that lacks least: any that will do, then the one of least critical friction.
State best_of(const Ground& ground, int node, const std::vector<State>& among) {
  State best = -1;
  double least = 0.0;
  for (const State state : among) {
    if (node_of(state) != node) continue;
    const double friction = ground.critical_friction(state);
    if (best < 0 || friction < least) {
      best = state;
      least = friction;
    }
  }
  return best;
}

}  // namespace

std::vector<State> cut(const Ground& ground, const std::vector<bool>& reached, int goal_node) {
  std::vector<bool> beside(reached.size());
  for (State state = 0; state < ground.states(); ++state) {
    if (!reached[index(state)]) continue;
    for (const int node : ground.adjacent(node_of(state)))
      for (const State other : states_of(node))
        if (!reached[index(other)]) beside[index(other)] = true;
  }
  std::vector<bool> seen(reached.size());
  std::vector<State> out, stack;
  const auto visit = [&](State state) {
    if (reached[index(state)] || seen[index(state)]) return;
    seen[index(state)] = true;
    (beside[index(state)] ? out : stack).push_back(state);
  };
  for (const State goal : states_of(goal_node)) visit(goal);
  while (!stack.empty()) {
    const State state = stack.back();
    stack.pop_back();
    for (const int node : ground.adjacent(node_of(state)))
      for (const State other : states_of(node)) visit(other);
  }
  const Vector3d& goal = ground.place(goal_node);
  std::sort(out.begin(), out.end(), [&](State a, State b) {
    const double far_a = (ground.place(node_of(a)) - goal).norm(), far_b = (ground.place(node_of(b)) - goal).norm();
    return far_a < far_b || (far_a == far_b && a < b);
  });
  return out;
}

std::string describe_state(const Ground& ground, State state, const RouteOptions& options) {
  const int node = node_of(state);
  const Vector3d& p = ground.place(node);
  const std::string where =
      format("(%.2f, %.2f, %.2f), slope %.1f deg: ", p.x(), p.y(), p.z(), ground.slope(node) * 180.0 / std::numbers::pi);
  const Built& built = ground.standing(state);
  if (built.hindrance != Hindrance::kNone) return where + reason(built);
  if (allowed(ground, state, options)) return where + "stands, but no transition leads there";
  if (options.stability && ground.stable(state))
    return where + format("steeper than %.1f deg, over which the robot may not stand", options.steepest * 180.0 / std::numbers::pi);
  const double least = ground.critical_friction(state);
  if (!std::isfinite(least)) return where + "no friction would hold the robot";
  return where + format("needs friction %.2f, has %.2f", least, ground.options().friction);
}

Route blocked(const Ground& ground, const std::vector<bool>& reached, State from, int goal_node, const RouteOptions& options) {
  Route out;
  out.end = Route::End::kNoPath;
  const std::vector<State> goals = states_of(goal_node);
  const auto forbidden = [&](State state) { return !allowed(ground, state, options); };
  if (forbidden(from)) {
    out.cut = {from};
    out.blocked = "the start itself: " + describe_state(ground, from, options);
    return out;
  }
  if (std::all_of(goals.begin(), goals.end(), forbidden)) {
    out.cut = goals;
    out.blocked = "the goal itself: " + describe_state(ground, best_of(ground, goal_node, goals), options);
    return out;
  }
  out.cut = cut(ground, reached, goal_node);
  if (out.cut.empty()) {
    out.blocked = "the terrain under start and goal is not connected";
    return out;
  }
  std::vector<int> nodes;
  for (const State state : out.cut)
    if (nodes.empty() || nodes.back() != node_of(state)) nodes.push_back(node_of(state));
  out.blocked = format("%zu states at %zu places separate start and goal; nearest to the goal: ", out.cut.size(), nodes.size());
  for (std::size_t k = 0; k < std::min(kDescribed, nodes.size()); ++k)
    out.blocked += (k > 0 ? "; " : "") + describe_state(ground, best_of(ground, nodes[k], out.cut), options);
  return out;
}

}  // namespace foothold::octopod
