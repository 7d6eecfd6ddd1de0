// Backward labels: what is left to the goal from every state, by lower bounds alone.
//
// First components by A*, resumed as far as asked for. Second components only where they decide: along the edges that are tight,
// that is on a way of least first component, from the start on.
#pragma once

#include <queue>

#include "hyrecro/optimal/search.hpp"

namespace foothold::hyrecro {

// States are 2 * node (arrived) and 2 * node + 1 (departing). Used by one thread.
class Labels {
 public:
  Labels(RouteGraph& graph, std::size_t max_settled, const std::stop_token& stop);

  // Goes on until the state's first component is final, or nothing is left, or stopped, or `max_settled` states are.
  void settle(int state);
  // Settles `state` and finds the second components of all states on its ways of least first component.
  void settle_fully(int state);
  struct Estimate {
    Cost cost;           // never more than the true one; kNever: the goal is out of reach
    bool exact = false;  // its first component is final
  };
  Estimate estimate(int state);
  std::size_t settled() const { return settled_; }
  bool stopped() const { return stopped_; }

 private:
  struct Entry {
    double total, first;
    int state;
    friend bool operator<(const Entry& a, const Entry& b) {
      return b.total < a.total || (a.total == b.total && (a.first < b.first || (a.first == b.first && b.state < a.state)));
    }
  };
  bool step();
  bool empty() const { return waiting_ == 0; }
  double least_total();
  void relax(int state, double first);
  void expand(const Entry& entry);
  double second(int state);

  RouteGraph& graph_;
  const bool counts_;
  std::size_t max_settled_;
  const std::stop_token& stop_;
  std::vector<double> first_, second_;  // by state; second_ below 0: not known
  std::vector<char> final_;
  std::vector<double> bounds_;
  // Strides count in whole numbers: by their totals. What else is counted: in order.
  std::vector<std::vector<Entry>> buckets_;
  std::size_t bucket_ = 0, waiting_ = 0;
  std::priority_queue<Entry> queue_;
  double frontier_ = 0.0;  // no state that is not final has a lower total
  std::size_t settled_ = 0;
  bool stopped_ = false;
};

}  // namespace foothold::hyrecro
