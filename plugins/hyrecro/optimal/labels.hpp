// Backward labels: what is left to the goal from every state, by lower bounds alone. A*, resumed as far as asked for.
#pragma once

#include <queue>

#include "hyrecro/optimal/search.hpp"

namespace foothold::hyrecro {

// States are 2 * node (arrived) and 2 * node + 1 (departing). Used by one thread.
class Labels {
 public:
  Labels(RouteGraph& graph, std::size_t max_settled, const std::stop_token& stop);

  // Goes on until the state's label is final, or nothing is left, or stopped, or `max_settled` states are.
  void settle(int state);
  struct Estimate {
    Cost cost;  // never more than the true one; kNever: the goal is out of reach
    bool exact = false;
  };
  Estimate estimate(int state) const;
  std::size_t settled() const { return settled_; }
  bool stopped() const { return stopped_; }

 private:
  struct Entry {
    Cost total, cost;
    int state;
    friend bool operator<(const Entry& a, const Entry& b) { return b.total < a.total || (a.total == b.total && b.state < a.state); }
  };
  void relax(int state, const Cost& cost);
  void expand(const Entry& entry);

  RouteGraph& graph_;
  std::size_t max_settled_;
  const std::stop_token& stop_;
  std::vector<Cost> cost_;  // by state, so far
  std::vector<char> final_;
  std::vector<Cost> bounds_;
  std::priority_queue<Entry> queue_;
  Cost frontier_;  // no state that is not final has a lower total
  std::size_t settled_ = 0;
  bool stopped_ = false;
};

}  // namespace foothold::hyrecro
