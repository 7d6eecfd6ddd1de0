#include "hyrecro/optimal/large.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <set>

namespace foothold::hyrecro {
namespace {

constexpr double kStride = 0.45;   // m, of a leg's strides on the whole
constexpr double kChange = 2.0;    // strides that a transition costs, the turn before it included
constexpr int kMostWays = 400;     // that are walked, at most
constexpr std::size_t kPairs = 3;  // of footholds, for each transition between cells
constexpr int kMostRefused = 400;  // pairs that fail before the others are taken to fail
constexpr double kRefused = 3.0;   // strides that a transition costs more after a leg to or from it failed
constexpr double kHindered = 1.0;  // the same of a step from cell to cell near the ends of such a leg

class LargeSearch {
 public:
  LargeSearch(TrussGraph& graph, const Portals& portals, const std::stop_token& stop)
      : graph_(graph),
        portals_(portals),
        stop_(stop),
        start_(portals.cells()),
        goal_(portals.cells() + 1),
        more_(portals.edges(), 0.0F),
        cost_(static_cast<std::size_t>(portals.cells()) + 2),
        step_(cost_.size()) {
    add_ends();
  }

  SearchResult run() {
    SearchResult out;
    out.outcome = SearchResult::Outcome::kLimit;
    out.bound = {graph_.from_start(graph_.goal()), 0.0};
    for (int ways = 0; ways < kMostWays;) {
      if (stop_.stop_requested() || !find_way()) break;
      if (!evaluate_way()) continue;
      ++ways;
      if (!walk_way(out)) continue;
      out.outcome = SearchResult::Outcome::kFound;
      break;
    }
    if (out.outcome != SearchResult::Outcome::kFound && stop_.stop_requested()) out.outcome = SearchResult::Outcome::kStopped;
    out.settled = settled_;
    return out;
  }

 private:
  struct Step {  // from one cell to the next
    int from = -1, to = -1;
    bool leg = true;
    std::size_t edge = 0;  // of portals, or behind them: of own_
  };
  struct Own {
    int from, to;
    bool leg;
    double length;
  };
  using Pairs = std::vector<std::pair<int, int>>;

  void add_own(int from, int to, bool leg, double length) {
    own_.push_back({from, to, leg, length});
    more_.push_back(0.0F);
  }

  // Start and goal are cells, too.
  void add_ends() {
    for (const auto& [node, cell] : {std::pair(graph_.start(), start_), std::pair(graph_.goal(), goal_)}) {
      const Foothold& foothold = graph_.at(node);
      for (const Portals::Beside& beside : portals_.beside(foothold.face, foothold.at))
        node == graph_.start() ? add_own(cell, beside.cell, true, beside.distance)
                               : add_own(beside.cell, cell, true, beside.distance);
    }
    if (graph_.face_of(graph_.start()) == graph_.face_of(graph_.goal()))
      add_own(start_, goal_, true, (graph_.at(graph_.goal()).at - graph_.at(graph_.start()).at).norm());
    std::stable_sort(own_.begin(), own_.end(), [](const Own& a, const Own& b) { return a.from < b.from; });
  }

  double base(const Step& step, double length) const {
    const auto more = static_cast<double>(more_[step.edge]);
    return (step.leg ? length / kStride : kChange) + more;
  }

  const Vector3d& place(int cell) const {
    return cell < start_ ? portals_.middle(cell) : graph_.place(cell == start_ ? graph_.start() : graph_.goal());
  }

  double left(int cell) const { return (place(cell) - place(goal_)).norm() / kFastest; }

  // A* over cells.
  bool find_way() {
    struct Open {
      double total;
      int cell;
      bool operator<(const Open& o) const { return total != o.total ? total > o.total : cell > o.cell; }
    };
    std::fill(cost_.begin(), cost_.end(), std::numeric_limits<double>::infinity());
    std::priority_queue<Open> open;
    cost_[static_cast<std::size_t>(start_)] = 0.0;
    open.push({left(start_), start_});
    bool found = false;
    while (!open.empty() && !stop_.stop_requested()) {
      const Open top = open.top();
      open.pop();
      const double cost = cost_[static_cast<std::size_t>(top.cell)];
      if (top.total > cost + left(top.cell) + 1e-9) continue;
      if (top.cell == goal_) {
        found = true;
        break;
      }
      ++settled_;
      const auto relax = [&](const Step& step, double length) {
        const double there = cost + base(step, length);
        if (!(there < cost_[static_cast<std::size_t>(step.to)])) return;
        cost_[static_cast<std::size_t>(step.to)] = there;
        step_[static_cast<std::size_t>(step.to)] = step;
        open.push({there + left(step.to), step.to});
      };
      if (top.cell < start_) {
        std::size_t edge = portals_.first_edge(top.cell);
        for (const Portals::Edge& e : portals_.edges(top.cell)) relax({top.cell, e.to, e.leg, edge++}, e.length);
      }
      const auto own = std::lower_bound(own_.begin(), own_.end(), top.cell, [](const Own& o, int cell) { return o.from < cell; });
      for (auto o = own; o != own_.end() && o->from == top.cell; ++o)
        relax({o->from, o->to, o->leg, portals_.edges() + static_cast<std::size_t>(o - own_.begin())}, o->length);
    }
    way_.clear();
    if (!found) return false;
    for (int cell = goal_; cell != start_; cell = way_.back().from) way_.push_back(step_[static_cast<std::size_t>(cell)]);
    std::reverse(way_.begin(), way_.end());
    return true;
  }

  const Pairs& pairs(const Step& step) {
    const auto [entry, fresh] = pairs_.try_emplace(step.edge);
    if (!fresh) return entry->second;
    int refused = 0;
    for (const auto& [a, b] : portals_.opposite(step.from, step.to)) {
      if (!graph_.footing(a) || !graph_.footing(b)) continue;
      if (graph_.transition(a, b)) {
        entry->second.emplace_back(a, b);
        if (entry->second.size() == kPairs) break;
      } else if (++refused == kMostRefused) {
        break;
      }
    }
    return entry->second;
  }

  // Whether all transitions of the way have footholds; those that have not leave the graph.
  bool evaluate_way() {
    bool all = true;
    for (const Step& step : way_)
      if (!step.leg && pairs(step).empty()) {
        more_[step.edge] = std::numeric_limits<float>::infinity();
        all = false;
      }
    return all;
  }

  bool walk_way(SearchResult& out) {
    changes_.clear();
    for (std::size_t k = 0; k < way_.size(); ++k)
      if (!way_[k].leg) changes_.push_back(k);
    failed_.clear();
    furthest_ = 0;
    hops_.clear();
    cost_of_ = {};
    if (walk_on(graph_.start(), 0)) {
      out.hops = hops_;
      std::reverse(out.hops.begin(), out.hops.end());
      out.cost = cost_of_;
      return true;
    }
    hinder();
    return false;
  }

  // From `node`, before the change number `change`.
  bool walk_on(int node, std::size_t change) {
    furthest_ = std::max(furthest_, change);
    if (stop_.stop_requested() || failed_.contains({change, node})) return false;
    if (change == changes_.size()) {
      const Cost cost = graph_.leg(node, graph_.goal(), false);
      if (!(cost == kNever)) {
        cost_of_ = cost_of_ + cost;
        hops_.push_back({node, graph_.goal(), true});
        return true;
      }
      failed_.insert({change, node});
      return false;
    }
    for (const auto& [a, b] : pairs(way_[changes_[change]])) {
      const Cost cost = a == node ? Cost{} : graph_.leg(node, a, false);
      if (cost == kNever || !walk_on(b, change + 1)) continue;
      hops_.push_back({a, b, false});
      cost_of_ = cost_of_ + graph_.cost(a, {b, -1, (graph_.place(a) - graph_.place(b)).norm()});
      if (a != node) {
        hops_.push_back({node, a, true});
        cost_of_ = cost_of_ + cost;
      }
      return true;
    }
    failed_.insert({change, node});
    return false;
  }

  // The leg before the change that none came beyond.
  void hinder() {
    const std::size_t begin = furthest_ == 0 ? 0 : changes_[furthest_ - 1];
    const std::size_t end = furthest_ == changes_.size() ? way_.size() - 1 : changes_[furthest_];
    for (std::size_t k = begin; k <= end; ++k) {
      if (way_[k].leg && k > begin + 2 && k + 2 < end) continue;
      more_[way_[k].edge] += static_cast<float>(way_[k].leg ? kHindered : kRefused);
    }
  }

  static constexpr double kFastest = 0.47;  // m a stride: nothing is estimated to take more
  TrussGraph& graph_;
  const Portals& portals_;
  const std::stop_token& stop_;
  const int start_, goal_;
  std::vector<Own> own_;     // edges of start and goal, by `from`
  std::vector<float> more_;  // strides, by edge
  std::vector<double> cost_;
  std::vector<Step> step_;
  std::vector<Step> way_;
  std::vector<std::size_t> changes_;  // of way_
  std::unordered_map<std::size_t, Pairs> pairs_;
  std::set<std::pair<std::size_t, int>> failed_;
  std::size_t furthest_ = 0, settled_ = 0;
  std::vector<Hop> hops_;  // backwards
  Cost cost_of_;
};

}  // namespace

SearchResult search_large(TrussGraph& graph, const Portals& portals, const std::stop_token& stop) {
  return LargeSearch(graph, portals, stop).run();
}

}  // namespace foothold::hyrecro
