// The motions of a whole route: stances' coordinates chosen along the route, then stride by stride.
//
// Each stance has some candidates with room to lift either foot; dynamic programming takes those that are nearest to each other (by
// the time that the actuators take). Where a stride between two of them has no motion in closed form, that pair is left out and
// the rest chosen again; only if a stride runs out of pairs, lifts by the whole robot and RRTConnect are tried.
#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "hyrecro/motion/move.hpp"
#include "hyrecro/motion/rise.hpp"
#include "hyrecro/motion/stances.hpp"

namespace foothold::hyrecro {
namespace {

// Pairs of a stride's candidates that are tried in closed form, and with all effort.
constexpr std::size_t kPairs = 4, kSearchedPairs = 3;
constexpr double kNever = std::numeric_limits<double>::infinity();

// Choice of stances and motions of strides, in turn.
class Chain {
 public:
  Chain(const Model& model, const Obstacles& obstacles, const truss::Truss& truss, const Route& route, const Coordinates& start,
        bool free_lifts, const MotionOptions& options, std::mt19937_64& random, const std::stop_token& stop)
      : model_(model), start_(start), free_lifts_(free_lifts), options_(options), random_(random), stop_(stop) {
    const std::size_t strides = route.strides.size();
    const std::unique_ptr<Reachability> exact = make_exact(model, options.clearance);
    const double height = kLiftFactor * options.lift;
    stances_.resize(strides + 1);
    Stance first = stance_of(model, swapped(start), height);
    if (!free_lifts) first.leaving = to_actuators(model, start);
    stances_[0].push_back(first);
    for (std::size_t i = 0; i < strides; ++i) {
      const Foothold& holds = i == 0 ? route.start : route.strides[i - 1].to;
      around_.push_back({model, obstacles, pose_of(truss, holds), options.clearance, stop});
      const bool last = i + 1 == strides;
      stances_[i + 1] =
          stances_at(around_[i], *exact, pose_of(truss, route.strides[i].to), route.strides[i].coordinates, last, height, reason_);
      const bool stopped = stop.stop_requested();
      if (stopped) reason_ = "stopped";
      if (!stances_[i + 1].empty() && !stopped) continue;
      impossible_ = static_cast<int>(i);
      break;
    }
    choice_.assign(strides + 1, 0);
    refused_.assign(strides, 0);
  }

  RouteMotions run(const Route& route) {
    RouteMotions out{route, {}, impossible_, reason_};
    bool all = impossible_ < 0 && refused_.empty();
    while (!all && impossible_ < 0) {
      if (!choose()) {
        const std::size_t last = static_cast<std::size_t>(out.failed);
        if (refused_[last] >= kPairs) break;
        all_effort(last);
        continue;
      }
      const std::optional<std::size_t> at = make_all(out.reason);
      all = !at;
      if (all) break;
      out.failed = static_cast<int>(*at);
      blocked_.insert(pair_of(*at));
      if (++refused_[*at] == kPairs) all_effort(*at);
      if (refused_[*at] >= kPairs + kSearchedPairs || stop_.stop_requested()) break;
    }
    if (all) out.failed = -1, out.reason.clear();
    for (std::size_t i = 0; impossible_ < 0 && i < refused_.size(); ++i) {
      const auto made = made_.find(pair_of(i));
      if (made == made_.end()) break;
      out.route.strides[i].coordinates = stances_[i + 1][choice_[i + 1]].coordinates;
      out.motions.push_back(std::move(made->second));
    }
    return out;
  }

 private:
  // A stride between two of its stances.
  struct Pair {
    std::size_t stride, from, to;
    auto operator<=>(const Pair&) const = default;
  };
  Pair pair_of(std::size_t stride) const { return {stride, choice_[stride], choice_[stride + 1]}; }

  // Motions between the chosen stances; the first stride that has none.
  std::optional<std::size_t> make_all(std::string& reason) {
    for (std::size_t i = 0; i < refused_.size(); ++i) {
      if (made_.contains(pair_of(i))) continue;
      MotionResult result = make(i);
      if (!result.motion) {
        reason = result.reason;
        return i;
      }
      made_.emplace(pair_of(i), std::move(*result.motion));
    }
    return std::nullopt;
  }

  // From now on lifts by the whole robot and RRTConnect may be used; what was refused without them may be tried again.
  void all_effort(std::size_t stride) {
    refused_[stride] = kPairs;
    std::erase_if(blocked_, [stride](const Pair& pair) { return pair.stride == stride; });
  }

  MotionResult make(std::size_t i) {
    const bool hard = refused_[i] >= kPairs;
    const Coordinates from = i == 0 ? start_ : swapped(stances_[i][choice_[i]].coordinates);
    return move(around_[i], from, stances_[i + 1][choice_[i + 1]].coordinates, i > 0 || free_lifts_, options_,
                {hard || i == 0 || !stances_[i][choice_[i]].leaves, hard || !stances_[i + 1][choice_[i + 1]].lands, hard}, random_);
  }

  // The cheapest choice of stances without blocked pairs; false if there is none.
  bool choose() {
    const std::size_t strides = refused_.size();
    std::vector<std::vector<double>> cost(strides + 1);
    std::vector<std::vector<std::size_t>> best(strides + 1);
    cost[0] = {0.0};
    for (std::size_t i = 0; i < strides; ++i) {
      cost[i + 1].assign(stances_[i + 1].size(), kNever);
      best[i + 1].assign(stances_[i + 1].size(), 0);
      for (std::size_t b = 0; b < stances_[i + 1].size(); ++b)
        for (std::size_t a = 0; a < stances_[i].size(); ++a) {
          if (cost[i][a] == kNever || blocked_.contains({i, a, b})) continue;
          const Actuators& leaving = stances_[i][a].leaving;
          const Stance& next = stances_[i + 1][b];
          const double sum = cost[i][a] + next.cost + duration(model_, leaving, with_nearest_turns(leaving, next.landing));
          if (sum < cost[i + 1][b]) {
            cost[i + 1][b] = sum;
            best[i + 1][b] = a;
          }
        }
    }
    const auto end = std::min_element(cost[strides].begin(), cost[strides].end());
    if (*end == kNever) return false;
    choice_[strides] = static_cast<std::size_t>(end - cost[strides].begin());
    for (std::size_t i = strides; i > 0; --i) choice_[i - 1] = best[i][choice_[i]];
    return true;
  }

  const Model& model_;
  const Coordinates& start_;
  bool free_lifts_;
  const MotionOptions& options_;
  std::mt19937_64& random_;
  const std::stop_token& stop_;
  std::vector<std::vector<Stance>> stances_;  // [i]: before stride i
  std::vector<Surroundings> around_;          // [i]: while stride i is made
  std::vector<std::size_t> choice_;           // of stances_[i]
  std::vector<std::size_t> refused_;          // pairs of stride i
  std::set<Pair> blocked_;
  std::map<Pair, Motion> made_;
  int impossible_ = -1;  // a stride without any stance, and why
  std::string reason_;
};

}  // namespace

RouteMotions plan_motions(const Model& model, const Obstacles& obstacles, const truss::Truss& truss, const Route& route,
                          const Coordinates& start, bool free_lifts, const MotionOptions& options, std::mt19937_64& random,
                          const std::stop_token& stop) {
  return Chain(model, obstacles, truss, route, start, free_lifts, options, random, stop).run(route);
}

}  // namespace foothold::hyrecro
