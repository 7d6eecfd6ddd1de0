// The search over a whole route: legs on faces and transitions between faces, jointly.
//
// A route alternates: arrive at a foothold (start, or by a transition), walk a leg on that face (perhaps of length zero), depart
// from its end by a transition, and so on until a leg ends at the goal. States are therefore "arrived at u" and "departing from v".
// Costs compare lexicographically. Two searches: backwards from the goal with lower bounds alone (labels.hpp), which gives the
// forward one an exact heuristic for those bounds; forwards lazily (Dellin and Srinivasa 2016, lazy weighted A*): a leg or
// transition is evaluated only when its end is about to be settled.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace foothold::hyrecro {

struct Cost {
  double first = 0.0, second = 0.0;

  friend Cost operator+(const Cost& a, const Cost& b) { return {a.first + b.first, a.second + b.second}; }
  friend bool operator<(const Cost& a, const Cost& b) { return a.first < b.first || (a.first == b.first && a.second < b.second); }
  friend bool operator==(const Cost& a, const Cost& b) = default;
};
inline constexpr Cost kNever{std::numeric_limits<double>::infinity(), 0.0};

// What the search is about. Nodes are numbered from 0; every node lies on one face.
class RouteGraph {
 public:
  struct Transition {
    int to = -1;
    int kind = -1;          // the graph's own
    double distance = 0.0;  // m, between the two
  };
  virtual ~RouteGraph() = default;
  virtual int nodes() const = 0;
  virtual int start() const = 0;
  virtual int goal() const = 0;
  virtual int face_of(int node) const = 0;
  virtual std::span<const int> on_face(int face) const = 0;
  // Lower bounds of legs between `node` and each of on_face(face_of(node)), in that order; symmetric, and they fulfil the triangle
  // inequality. 0 for the node itself.
  virtual void leg_bounds(int node, std::span<Cost> out) = 0;
  virtual void leg_firsts(int node, std::span<double> out) = 0;  // their first components alone
  // What is known to be possible, or to be impossible (kNever); never less than the bound. `proved`: what no leg can be cheaper
  // than.
  virtual Cost leg(int from, int to, bool proved) = 0;
  // Looks harder for a leg that costs no more than leg(from, to, true). If there is none to be found, that one says more from now
  // on than what is proved.
  virtual bool achieve(int from, int to) = 0;
  // Transitions that may be possible, in two parts; symmetric. Valid until the next call.
  virtual std::array<std::span<const Transition>, 2> transitions(int node) = 0;
  virtual Cost cost(int node, const Transition& transition) const = 0;
  // The first component counts strides: 1 for each transition.
  virtual bool counts() const = 0;
  virtual bool transition(int from, int to) = 0;
  // How many legs and transitions are evaluated for the best route before a good one must do.
  virtual std::size_t patience() const = 0;
  // Lower bounds of everything from the start to `node`, of the first component (consistent), and of everything from `node` to the
  // goal, of the second.
  virtual double from_start(int node) = 0;
  virtual double second_to_goal(int node) = 0;
};

struct Hop {
  int from = -1, to = -1;
  bool leg = false;
};

struct SearchResult {
  enum class Outcome { kFound, kNone, kStopped, kLimit };
  Outcome outcome = Outcome::kNone;
  std::vector<Hop> hops;    // without legs of length zero
  Cost cost;                // of kFound
  Cost bound = kNever;      // no route costs less, whatever evaluation finds
  std::size_t settled = 0;  // states
};

// Looks at `stop` every few microseconds. `max_settled`: states, of both searches together.
SearchResult search_route(RouteGraph& graph, std::size_t max_settled, const std::stop_token& stop);

}  // namespace foothold::hyrecro
