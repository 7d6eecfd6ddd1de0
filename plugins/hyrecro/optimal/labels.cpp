#include "hyrecro/optimal/labels.hpp"

#include <algorithm>

namespace foothold::hyrecro {

Labels::Labels(RouteGraph& graph, std::size_t max_settled, const std::stop_token& stop)
    : graph_(graph), max_settled_(max_settled), stop_(stop) {
  const std::size_t states = 2 * static_cast<std::size_t>(graph.nodes());
  cost_.assign(states, kNever);
  final_.assign(states, 0);
  relax(2 * graph.goal() + 1, {});
}

void Labels::relax(int state, const Cost& cost) {
  const std::size_t i = static_cast<std::size_t>(state);
  if (final_[i] || !(cost < cost_[i])) return;
  cost_[i] = cost;
  queue_.push({cost + graph_.from_start(state / 2), cost, state});
}

void Labels::settle(int state) {
  while (!final_[static_cast<std::size_t>(state)] && !queue_.empty()) {
    if (stop_.stop_requested()) stopped_ = true;
    if (stopped_ || settled_ > max_settled_) return;
    const Entry entry = queue_.top();
    queue_.pop();
    frontier_ = entry.total;
    const std::size_t i = static_cast<std::size_t>(entry.state);
    if (final_[i]) continue;
    final_[i] = 1;
    ++settled_;
    expand(entry);
  }
}

void Labels::expand(const Entry& entry) {
  const int node = entry.state / 2;
  if (entry.state % 2 == 0) {
    for (const RouteGraph::Transition& transition : graph_.transitions(node))
      relax(2 * transition.to + 1, entry.cost + transition.cost);
    return;
  }
  // By the triangle inequality whoever comes to walk on from here by a leg does not do worse by going there at once.
  if (!(entry.cost < cost_[2 * static_cast<std::size_t>(node)])) return;
  const std::span<const int> there = graph_.on_face(graph_.face_of(node));
  bounds_.resize(there.size());
  graph_.leg_bounds(node, bounds_);
  for (std::size_t i = 0; i < there.size(); ++i) relax(2 * there[i], entry.cost + bounds_[i]);
}

Labels::Estimate Labels::estimate(int state) const {
  const std::size_t i = static_cast<std::size_t>(state);
  if (final_[i]) return {cost_[i], true};
  if (queue_.empty()) return {kNever, true};
  const Cost from = graph_.from_start(state / 2);
  return {std::max(Cost{}, Cost{frontier_.first - from.first, frontier_.second - from.second}), false};
}

}  // namespace foothold::hyrecro
