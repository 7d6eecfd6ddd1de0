// A* over (node, orientation), after Molla-Santamaria et al. 2023, section 5, whose A* keeps one orientation to a node and so is
// not optimal on its own cost: q depends on the orientation before.
//
// f = g + h. h: the distance to the goal over the nodes, plus the change of posture to the nearest of the goal's postures. Both are
// consistent (q is a metric), so a state is closed at its least cost.
//
// Lazy (after Cohen, Phillips, Likhachev 2014): a node is promised first, with a lower bound of its states' f that needs no posture
// of them (triangle inequality: w q(u, v) plus v's change to the goal is at least u's own); their postures and verdicts are made
// when the promise comes up, and whether the edge to a state is open is asked when the state itself does.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>

#include "octopod/search/cut.hpp"
#include "octopod/search/distances.hpp"
#include "octopod/search/open_list.hpp"
#include "octopod/search/route.hpp"

namespace foothold::octopod {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum class Stage : std::uint8_t { kUnknown, kJudged, kClosed, kForbidden };

// f is g + change_left + the distance over the nodes.
struct Seen {
  double g = kInfinity;
  double change_left = 0.0;  // weighted change to the nearest of the goal's postures
  State parent = -1;
  Stage stage = Stage::kUnknown;
};

class Search {
 public:
  Search(const Ground& ground, State from, int goal_node, const RouteOptions& options, const Edge& edge,
         const std::stop_token& stop)
      : ground_(ground),
        from_(from),
        goal_node_(goal_node),
        options_(options),
        edge_(edge),
        stop_(stop),
        distances_(distances_to(ground, goal_node, options.stability ? options.steepest : std::numbers::pi)),
        seen_(static_cast<std::size_t>(ground.states())),
        promised_(static_cast<std::size_t>(ground.nodes()), kInfinity),
        looked_at_(static_cast<std::size_t>(ground.nodes())),
        open_(ground.states() + ground.nodes()) {
    // With no way over nodes that are gentle enough, the search still shows what it reaches and where that ends.
    if (distances_[static_cast<std::size_t>(node_of(from))] == kInfinity)
      distances_ = distances_to(ground, goal_node, std::numbers::pi);
    for (State goal = kOrientations * goal_node; goal < kOrientations * (goal_node + 1); ++goal)
      if (allowed(goal)) goals_.push_back(goal);
  }

  Route run();

 private:
  Seen& at(State state) { return seen_[static_cast<std::size_t>(state)]; }
  bool allowed(State state) const { return octopod::allowed(ground_, state, options_); }
  // Open with what f is now, unless the goal is out of reach from there.
  void put(State state) {
    const Seen& seen = at(state);
    const double f = seen.g + seen.change_left + distances_[static_cast<std::size_t>(node_of(state))];
    if (f < kInfinity) open_.put(state, f);
  }
  // Exact if less than `enough`, or else something that is not.
  double weighted_change(State a, State b, double enough) const {
    const double w = options_.posture_weight;
    if (w <= 0.0) return 0.0;
    return w * change(ground_.standing(a).standing, ground_.standing(b).standing, options_.weights, enough / w);
  }
  double change_left(State state) const {
    double least = kInfinity;
    for (const State goal : goals_) least = std::min(least, weighted_change(state, goal, least));
    return least;
  }

  // Which states of the node will do; those are open with their least costs over the closed states beside them.
  void judge(int node);
  // Reaches the state from a closed one beside it, d (m) away, if that is cheaper. Returns whether it is.
  bool offer(State state, State parent, double d) {
    Seen& seen = at(state);
    const double before = at(parent).g + d, enough = seen.g - before;
    if (enough <= 0.0) return false;
    const double more = weighted_change(parent, state, enough);
    if (more >= enough || before + more >= seen.g) return false;
    seen.g = before + more;
    seen.parent = parent;
    return true;
  }
  // The way to it that costs least, of the ways that are not known to be shut.
  void choose_parent(State state);
  bool passable(State state);
  void expand(State state);
  Route route_to(State goal);
  Route no_path();

  const Ground& ground_;
  State from_;
  int goal_node_;
  const RouteOptions& options_;
  const Edge& edge_;
  const std::stop_token& stop_;
  std::vector<double> distances_;
  std::vector<State> goals_;
  std::vector<Seen> seen_;
  std::vector<double> promised_;                        // by node: g + change_left of any of its states, at least
  std::vector<bool> looked_at_;                         // nodes whose promise came up
  std::unordered_map<State, std::vector<State>> shut_;  // by state: from where it was asked for and refused
  OpenList open_;                                       // states, and behind them promised nodes
};

void Search::judge(int node) {
  looked_at_[static_cast<std::size_t>(node)] = true;
  for (State state = kOrientations * node; state < kOrientations * (node + 1); ++state) {
    Seen& seen = at(state);
    if (seen.stage != Stage::kUnknown) continue;
    seen.stage = allowed(state) ? Stage::kJudged : Stage::kForbidden;
    if (seen.stage == Stage::kForbidden) continue;
    seen.change_left = change_left(state);
    choose_parent(state);
  }
}

void Search::choose_parent(State state) {
  Seen& seen = at(state);
  seen.g = kInfinity;
  const auto shut = shut_.find(state);
  const auto beside = ground_.adjacent(node_of(state));
  const auto lengths = ground_.lengths(node_of(state));
  for (std::size_t k = 0; k < beside.size(); ++k) {
    const int node = beside[k];
    for (State other = kOrientations * node; other < kOrientations * (node + 1); ++other) {
      if (at(other).stage != Stage::kClosed) continue;
      if (shut != shut_.end() && std::find(shut->second.begin(), shut->second.end(), other) != shut->second.end()) continue;
      offer(state, other, lengths[k]);
    }
  }
  if (seen.g < kInfinity) put(state);
}

bool Search::passable(State state) {
  const State parent = at(state).parent;
  if (!edge_ || parent < 0 || edge_(parent, state)) return true;
  shut_[state].push_back(parent);
  choose_parent(state);
  return false;
}

void Search::expand(State state) {
  const Seen& self = at(state);
  const auto beside = ground_.adjacent(node_of(state));
  const auto lengths = ground_.lengths(node_of(state));
  for (std::size_t k = 0; k < beside.size(); ++k) {
    const auto other = static_cast<std::size_t>(beside[k]);
    const double promise = self.g + lengths[k] + self.change_left;
    if (!looked_at_[other]) {
      if (promise >= promised_[other]) continue;
      promised_[other] = promise;
      open_.put(ground_.states() + beside[k], promise + distances_[other]);
      continue;
    }
    for (State next = kOrientations * beside[k]; next < kOrientations * (beside[k] + 1); ++next) {
      const Seen& seen = at(next);
      if (seen.stage == Stage::kJudged && promise < seen.g + seen.change_left && offer(next, state, lengths[k])) put(next);
    }
  }
}

Route Search::route_to(State goal) {
  Route out;
  out.end = Route::End::kFound;
  out.cost = out.bound = at(goal).g;
  out.optimal = true;
  for (State state = goal; state >= 0; state = at(state).parent) {
    out.states.push_back(state);
    out.costs.push_back(at(state).g);
  }
  std::reverse(out.states.begin(), out.states.end());
  std::reverse(out.costs.begin(), out.costs.end());
  return out;
}

Route Search::no_path() {
  std::vector<bool> reached(seen_.size());
  std::transform(seen_.begin(), seen_.end(), reached.begin(), [](const Seen& seen) { return seen.stage == Stage::kClosed; });
  reached[static_cast<std::size_t>(from_)] = true;
  return blocked(ground_, reached, from_, goal_node_, options_);
}

Route Search::run() {
  long expanded = 0;
  Route out;
  if (!goals_.empty() && allowed(from_)) {
    at(from_) = {0.0, change_left(from_), -1, Stage::kJudged};
    put(from_);
  }
  while (true) {
    if (open_.empty()) {
      out = no_path();
      break;
    }
    out.bound = std::max(out.bound, open_.least());
    if (stop_.stop_requested()) {
      out.end = Route::End::kStopped;
      break;
    }
    const int state = open_.pop();
    if (state >= ground_.states()) {
      judge(state - ground_.states());
      continue;
    }
    if (!passable(state)) continue;
    at(state).stage = Stage::kClosed;
    if (node_of(state) == goal_node_) {
      out = route_to(state);
      break;
    }
    if (expanded >= options_.max_states) {
      out.end = Route::End::kExhausted;
      break;
    }
    ++expanded;
    expand(state);
  }
  out.expanded = expanded;
  return out;
}

}  // namespace

double step_cost(const Ground& ground, State from, State to, const RouteOptions& options) {
  const double d = (ground.place(node_of(to)) - ground.place(node_of(from))).norm();
  return d + options.posture_weight * change(ground.standing(from).standing, ground.standing(to).standing, options.weights);
}

Route optimal_route(const Ground& ground, State from, int goal_node, const RouteOptions& options, const Edge& edge,
                    const std::stop_token& stop) {
  const long before = ground.postures_made();
  Route out = Search(ground, from, goal_node, options, edge, stop).run();
  out.postures = ground.postures_made() - before;
  return out;
}

}  // namespace foothold::octopod
