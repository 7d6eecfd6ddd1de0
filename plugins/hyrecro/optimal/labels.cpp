#include "hyrecro/optimal/labels.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::hyrecro {
namespace {

constexpr double kTight = 1e-9;  // as near two sums of first components are that count as equal

std::size_t at(int state) { return static_cast<std::size_t>(state); }

}  // namespace

Labels::Labels(RouteGraph& graph, std::size_t max_settled, const std::stop_token& stop)
    : graph_(graph), counts_(graph.counts()), max_settled_(max_settled), stop_(stop) {
  const std::size_t states = 2 * static_cast<std::size_t>(graph.nodes());
  first_.assign(states, kNever.first);
  second_.assign(states, -1.0);
  final_.assign(states, 0);
  relax(2 * graph.goal() + 1, 0.0);
}

void Labels::relax(int state, double first) {
  if (!(first < first_[at(state)]) || final_[at(state)]) return;
  first_[at(state)] = first;
  const Entry entry{first + graph_.from_start(state / 2), first, state};
  ++waiting_;
  if (!counts_) {
    queue_.push(entry);
    return;
  }
  const auto bucket = static_cast<std::size_t>(entry.total);
  if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
  buckets_[bucket].push_back(entry);
}

// Precondition: not empty().
double Labels::least_total() {
  if (!counts_) return queue_.top().total;
  while (buckets_[bucket_].empty()) ++bucket_;
  return static_cast<double>(bucket_);
}

void Labels::settle(int state) {
  while (!final_[at(state)] && step()) continue;
}

// False: nothing is left to do, or no more must be done.
bool Labels::step() {
  if (stop_.stop_requested()) stopped_ = true;
  if (empty() || stopped_ || settled_ > max_settled_) return false;
  frontier_ = least_total();
  const Entry entry = counts_ ? buckets_[bucket_].back() : queue_.top();
  if (counts_)
    buckets_[bucket_].pop_back();
  else
    queue_.pop();
  --waiting_;
  if (final_[at(entry.state)]) return true;
  final_[at(entry.state)] = 1;
  ++settled_;
  expand(entry);
  return true;
}

void Labels::settle_fully(int state) {
  settle(state);
  if (!final_[at(state)]) return;
  // States as good as the last one may lie on other ways.
  const double total = first_[at(state)] + graph_.from_start(state / 2);
  while (!empty() && least_total() <= total + kTight && step()) continue;
  second(state);
}

void Labels::expand(const Entry& entry) {
  const int node = entry.state / 2;
  if (entry.state % 2 == 0) {
    for (const auto part : graph_.transitions(node))
      for (const RouteGraph::Transition& transition : part)
        relax(2 * transition.to + 1, entry.first + (counts_ ? 1.0 : graph_.cost(node, transition).first));
    return;
  }
  // By the triangle inequality whoever comes to walk on from here by a leg does not do worse by going there at once.
  if (!(entry.first < first_[2 * at(node)])) return;
  const std::span<const int> there = graph_.on_face(graph_.face_of(node));
  bounds_.resize(there.size());
  graph_.leg_firsts(node, bounds_);
  for (std::size_t i = 0; i < there.size(); ++i) relax(2 * there[i], entry.first + bounds_[i]);
}

// Every tight edge leads to a state that is nearer to the goal, or from arriving to departing at one place: no recursion without
// end, and none deeper than twice the strides of the route.
double Labels::second(int state) {
  if (second_[at(state)] >= 0.0) return second_[at(state)];
  if (state == 2 * graph_.goal() + 1) return second_[at(state)] = 0.0;
  double best = kNever.first;
  const int node = state / 2;
  const auto tight = [&](double step, int next) {
    return final_[at(next)] && std::fabs(step + first_[at(next)] - first_[at(state)]) <= kTight;
  };
  if (state % 2 == 1) {
    for (const auto part : graph_.transitions(node))
      for (const RouteGraph::Transition& transition : part) {
        const Cost cost = graph_.cost(node, transition);
        if (tight(cost.first, 2 * transition.to)) best = std::min(best, cost.second + second(2 * transition.to));
      }
  } else {
    const std::span<const int> there = graph_.on_face(graph_.face_of(node));
    std::vector<Cost> bounds(there.size());
    graph_.leg_bounds(node, bounds);
    for (std::size_t i = 0; i < there.size(); ++i)
      if (tight(bounds[i].first, 2 * there[i] + 1)) best = std::min(best, bounds[i].second + second(2 * there[i] + 1));
  }
  return second_[at(state)] = best;
}

Labels::Estimate Labels::estimate(int state) {
  const double second = second_[at(state)] >= 0.0 ? second_[at(state)] : graph_.second_to_goal(state / 2);
  if (final_[at(state)]) return {{first_[at(state)], second}, true};
  if (empty()) return {kNever, true};
  return {{std::max(0.0, frontier_ - graph_.from_start(state / 2)), second}, false};
}

}  // namespace foothold::hyrecro
