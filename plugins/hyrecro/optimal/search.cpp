#include "hyrecro/optimal/search.hpp"

#include <algorithm>
#include <queue>

#include "hyrecro/optimal/labels.hpp"

namespace foothold::hyrecro {
namespace {

struct Effort {
  bool proved = false;   // costs are what is proved, not what is found
  double weight = 1.0;   // of what is left to the goal: above 1 for any good route instead of the best
  std::size_t most = 0;  // evaluations
};
constexpr double kGreed = 3.0;
constexpr int kMostTries = 12;

// Forward, lazily. A state is 2 * node + (departing ? 1 : 0).
class Forward {
 public:
  Forward(RouteGraph& graph, Labels& labels, const Effort& effort, std::size_t max_settled, const std::stop_token& stop)
      : graph_(graph),
        labels_(labels),
        effort_(effort),
        max_settled_(max_settled),
        stop_(stop),
        parent_(2 * static_cast<std::size_t>(graph.nodes()), -2) {}

  SearchResult run() {
    SearchResult out;
    push({}, 2 * graph_.start(), -1, true);
    while (!queue_.empty()) {
      if (stop_.stop_requested() || labels_.stopped()) return ended(out, SearchResult::Outcome::kStopped);
      if (labels_.settled() + settled_ > max_settled_ || evaluations_ > effort_.most)
        return ended(out, SearchResult::Outcome::kLimit);
      const Entry entry = queue_.top();
      queue_.pop();
      if (parent_[static_cast<std::size_t>(entry.state)] != -2) continue;
      if (!entry.exact && refine(entry)) continue;
      if (!entry.evaluated && !evaluate(entry)) continue;
      parent_[static_cast<std::size_t>(entry.state)] = entry.parent;
      ++settled_;
      if (entry.state == 2 * graph_.goal() + 1) {
        trace(entry.state, out);
        out.cost = entry.cost;
        return ended(out, SearchResult::Outcome::kFound);
      }
      expand(entry);
    }
    return ended(out, labels_.stopped() ? SearchResult::Outcome::kStopped : SearchResult::Outcome::kNone);
  }

 private:
  struct Entry {
    Cost total, cost;
    int state, parent;
    bool evaluated, exact;
    std::size_t number;  // equal costs: first come, first served
    friend bool operator<(const Entry& a, const Entry& b) {
      return b.total < a.total || (a.total == b.total && b.number < a.number);
    }
  };

  Cost total(const Cost& cost, const Cost& rest) const {
    return {cost.first + effort_.weight * rest.first, cost.second + rest.second};
  }

  void push(const Cost& cost, int state, int parent, bool evaluated) {
    const Labels::Estimate rest = labels_.estimate(state);
    if (rest.cost == kNever) return;
    queue_.push({total(cost, rest.cost), cost, state, parent, evaluated, rest.exact, number_++});
  }

  // Takes the label to exactness; true if the entry had to go back (or out).
  bool refine(const Entry& entry) {
    labels_.settle(entry.state);
    const Labels::Estimate rest = labels_.estimate(entry.state);
    if (rest.cost == kNever) return true;
    if (!(entry.total < total(entry.cost, rest.cost))) return false;
    queue_.push({total(entry.cost, rest.cost), entry.cost, entry.state, entry.parent, entry.evaluated, true, entry.number});
    return true;
  }

  // True if the entry may be settled as it is.
  bool evaluate(const Entry& entry) {
    ++evaluations_;
    const int from = entry.parent / 2, to = entry.state / 2;
    if (entry.state % 2 == 0) return graph_.transition(from, to);
    const Cost real = graph_.leg(from, to, effort_.proved);
    if (real == kNever) return false;
    const Cost cost = arrived_.at(static_cast<std::size_t>(from)) + real;
    if (!(entry.cost < cost)) return true;
    const Labels::Estimate rest = labels_.estimate(entry.state);
    queue_.push({total(cost, rest.cost), cost, entry.state, entry.parent, true, rest.exact, entry.number});
    return false;
  }

  void expand(const Entry& entry) {
    const int node = entry.state / 2;
    if (entry.state % 2 == 1) {
      for (const auto part : graph_.transitions(node))
        for (const RouteGraph::Transition& transition : part)
          if (parent_[2 * static_cast<std::size_t>(transition.to)] == -2)
            push(entry.cost + graph_.cost(node, transition), 2 * transition.to, entry.state, false);
      return;
    }
    if (arrived_.empty()) arrived_.resize(static_cast<std::size_t>(graph_.nodes()), kNever);
    arrived_[static_cast<std::size_t>(node)] = entry.cost;
    const std::span<const int> there = graph_.on_face(graph_.face_of(node));
    bounds_.resize(there.size());
    graph_.leg_bounds(node, bounds_);
    for (std::size_t i = 0; i < there.size(); ++i)
      if (parent_[2 * static_cast<std::size_t>(there[i]) + 1] == -2)
        push(entry.cost + bounds_[i], 2 * there[i] + 1, entry.state, there[i] == node);
  }

  void trace(int state, SearchResult& out) const {
    for (int at = state; parent_[static_cast<std::size_t>(at)] >= 0; at = parent_[static_cast<std::size_t>(at)]) {
      const int before = parent_[static_cast<std::size_t>(at)];
      if (at / 2 != before / 2) out.hops.push_back({before / 2, at / 2, at % 2 == 1});
    }
    std::reverse(out.hops.begin(), out.hops.end());
  }

  SearchResult& ended(SearchResult& out, SearchResult::Outcome outcome) const {
    out.outcome = outcome;
    out.settled = settled_ + labels_.settled();
    return out;
  }

  RouteGraph& graph_;
  Labels& labels_;
  Effort effort_;
  std::size_t max_settled_;
  const std::stop_token& stop_;
  std::vector<int> parent_;  // by state; -2: not settled, -1: the root
  std::vector<Cost> arrived_;
  std::vector<Cost> bounds_;
  std::priority_queue<Entry> queue_;
  std::size_t number_ = 0, settled_ = 0, evaluations_ = 0;
};

}  // namespace

SearchResult search_route(RouteGraph& graph, std::size_t max_settled, const std::stop_token& stop) {
  SearchResult out;
  std::size_t settled = 0;
  const auto search = [&](const Effort& effort) {
    const std::size_t left = max_settled - std::min(settled, max_settled);
    Labels labels(graph, left, stop);
    labels.settle_fully(2 * graph.start());
    const Cost bound = labels.estimate(2 * graph.start()).cost;
    SearchResult found = Forward(graph, labels, effort, left, stop).run();
    settled += found.settled;
    found.bound = bound;
    return found;
  };
  using Outcome = SearchResult::Outcome;
  out = search({false, 1.0, graph.patience()});
  // Where so much is in the way that the best route would take long to find, a good one does.
  if (out.outcome == Outcome::kLimit && settled <= max_settled) out = search({false, kGreed, max_settled});
  // What was found out on the way has raised what can be proved.
  if (out.outcome == Outcome::kFound && out.bound.first < out.cost.first) {
    SearchResult proof = search({true, 1.0, graph.patience()});
    if (proof.outcome == Outcome::kStopped) return proof;
    out.bound = std::min(proof.outcome == Outcome::kFound ? proof.cost : proof.bound, out.cost);
    // A route that no proof contradicts may have been missed.
    for (int tries = 0; tries < kMostTries && proof.outcome == Outcome::kFound && graph.counts(); ++tries) {
      if (!(proof.cost.first < out.cost.first)) break;
      const bool achieved = std::all_of(proof.hops.begin(), proof.hops.end(),
                                        [&](const Hop& hop) { return !hop.leg || graph.achieve(hop.from, hop.to); });
      if (achieved) {
        out.hops = proof.hops;
        out.cost = proof.cost;
        break;
      }
      proof = search({true, 1.0, graph.patience()});
      if (proof.outcome == Outcome::kStopped) return proof;
    }
  }
  out.settled = settled;
  return out;
}

}  // namespace foothold::hyrecro
