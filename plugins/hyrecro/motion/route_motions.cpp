// The motions of a whole route: stances' coordinates chosen along the route, then stride by stride.
//
// Each stance has some candidates with room to lift either foot; dynamic programming takes those that are nearest to each other (by
// the time that the actuators take). Where a stride between two of them has no motion in closed form, that pair is left out and
// the rest chosen again; only if a stride runs out of pairs, lifts by the whole robot and RRTConnect are tried.
#include <algorithm>
#include <limits>
#include <set>

#include "hyrecro/motion/lift.hpp"
#include "hyrecro/motion/liftable.hpp"
#include "hyrecro/motion/move.hpp"
#include "hyrecro/motion/rise.hpp"
#include "hyrecro/motion/solutions.hpp"
#include "hyrecro/reach/inverse.hpp"

namespace foothold::hyrecro {
namespace {

constexpr SolutionGrid kGrid{0.15, 0.02, 0.2};
// Candidates of a stance; pairs of a stride that are tried in closed form, and with all effort.
constexpr std::size_t kCandidates = 8, kPairs = 10, kSearchedPairs = 3;
// s: what a candidate without room to lift costs.
constexpr double kNoRoom = 20.0;
constexpr double kNever = std::numeric_limits<double>::infinity();

// A posture on two footholds, seen from the foot that held when it was reached.
struct Stance {
  Coordinates coordinates;
  Actuators landing, leaving;        // with the foot lifted: just before (same view), and just after (seen from the other foot)
  bool lands = true, leaves = true;  // one leg alone has room to lift its foot
  double cost = 0.0;                 // s
};

Stance stance_of(const Model& model, const Coordinates& c, double height) {
  const std::optional<Coordinates> landing = lifted(model, c, height), leaving = lifted(model, swapped(c), height);
  return {c,
          to_actuators(model, landing.value_or(c)),
          to_actuators(model, leaving.value_or(swapped(c))),
          landing.has_value(),
          leaving.has_value(),
          (landing ? 0.0 : kNoRoom) + (leaving ? 0.0 : kNoRoom)};
}

// How far from the middle of their strokes the actuators are, s.
double eccentricity(const Model& model, const Actuators& q) {
  const double middle = 0.5 * (model.mechanism.shortest() + model.mechanism.longest());
  return (q.head<8>().array() - middle).abs().maxCoeff() / model.actuator_speed;
}

// Empty if no posture is found with the one or the other foot lifted; then `reason` says so.
std::vector<Stance> candidates(const Surroundings& around, Reachability& exact, const Isometry3d& placed, const Coordinates& given,
                               bool last, double height, std::string& reason) {
  const Model& model = around.model;
  const Isometry3d pose = around.holding.inverse(Eigen::Isometry) * placed;
  Surroundings from_placed{model, around.obstacles, placed, around.clearance, around.stop};
  std::vector<Stance> out, all;
  for (const Coordinates& c : solutions(model, pose, kGrid, nullptr)) {
    Stance stance = stance_of(model, c, height);
    if (last && lifted(model, c, height)) stance.cost = 0.0;
    if (stance.cost > 0.0) continue;
    stance.cost = eccentricity(model, to_actuators(model, c));
    all.push_back(std::move(stance));
  }
  std::stable_sort(all.begin(), all.end(), [](const Stance& a, const Stance& b) { return a.cost < b.cost; });
  // Half of them may be of one side of the hip.
  std::array<std::size_t, 2> taken{0, 0};
  for (Stance& stance : all) {
    std::size_t& of_side = taken[std::cos(stance.coordinates.hip[0]) < 0.0 ? 1 : 0];
    if (of_side == kCandidates / 2 || judge_posture(around, stance.coordinates) ||
        judge_posture(around, from_actuators(model, stance.landing)) ||
        (!last && judge_posture(from_placed, from_actuators(model, stance.leaving))))
      continue;
    ++of_side;
    out.push_back(std::move(stance));
    if (out.size() == kCandidates) break;
  }
  if (out.empty()) {
    // At the border of the workspace the grid finds nothing; exact reachability does, from above.
    const auto below = [&](const Coordinates& top, const Isometry3d& of) {
      const std::optional<Coordinates> by_leg = lifted(model, top, -height);
      return by_leg ? by_leg : inverse(model, of, branch_of(top), free_of(model, top));
    };
    const auto from_above = [&](const Surroundings& view, const Isometry3d& of) {
      std::optional<Coordinates> stance;
      exact.reach(of * Eigen::Translation3d(0.0, 0.0, height), [&](const Coordinates& top) {
        stance = below(top, of);
        if (stance && (judge_posture(view, top) || judge_posture(view, *stance))) stance.reset();
        return stance.has_value();
      });
      return stance;
    };
    if (!free_foot_liftable(exact, pose, height)) {
      reason = "the foot cannot be set down: at its place it cannot be lifted, reachability ends there";
      return {};
    }
    if (!last && !holding_foot_liftable(exact, pose, height)) {
      reason = "the other foot could not be lifted next: reachability ends there";
      return {};
    }
    if (const auto stance = from_above(around, pose)) out.push_back(stance_of(model, *stance, height));
    if (!last)
      if (const auto stance = from_above(from_placed, pose.inverse(Eigen::Isometry)))
        out.push_back(stance_of(model, swapped(*stance), height));
  }
  out.push_back(stance_of(model, given, height));
  return out;
}

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
      stances_[i + 1] = candidates(around_[i], *exact, pose_of(truss, route.strides[i].to), route.strides[i].coordinates,
                                   i + 1 == strides, height, reason_);
      if (!stances_[i + 1].empty()) continue;
      impossible_ = static_cast<int>(i);
      break;
    }
    choice_.assign(strides + 1, 0);
    refused_.assign(strides, 0);
  }

  RouteMotions run(const Route& route) {
    RouteMotions out{route, {}, impossible_, reason_};
    if (impossible_ >= 0) return out;
    while (made_.size() < refused_.size()) {
      if (!choose()) {
        const std::size_t last = static_cast<std::size_t>(out.failed);
        if (refused_[last] >= kPairs) break;
        all_effort(last);
        continue;
      }
      while (!made_.empty() && !made_.back().of(choice_, made_.size() - 1)) made_.pop_back();
      const std::size_t next = made_.size();
      MotionResult result = make(next);
      if (result.motion) {
        made_.push_back({choice_[next], choice_[next + 1], std::move(*result.motion)});
        continue;
      }
      out.failed = static_cast<int>(next);
      out.reason = result.reason;
      blocked_.insert({next, choice_[next], choice_[next + 1]});
      if (++refused_[next] == kPairs) all_effort(next);
      if (refused_[next] >= kPairs + kSearchedPairs || stop_.stop_requested()) break;
    }
    if (made_.size() == refused_.size()) out.failed = -1, out.reason.clear();
    for (std::size_t i = 0; i < made_.size(); ++i) {
      out.route.strides[i].coordinates = stances_[i + 1][made_[i].to].coordinates;
      out.motions.push_back(std::move(made_[i].motion));
    }
    return out;
  }

 private:
  struct Pair {
    std::size_t stride, from, to;
    auto operator<=>(const Pair&) const = default;
  };
  struct Made {
    std::size_t from, to;
    Motion motion;
    bool of(const std::vector<std::size_t>& choice, std::size_t stride) const {
      return from == choice[stride] && to == choice[stride + 1];
    }
  };

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
  std::vector<Made> made_;  // of the first strides
  int impossible_ = -1;     // a stride without any stance, and why
  std::string reason_;
};

}  // namespace

RouteMotions plan_motions(const Model& model, const Obstacles& obstacles, const truss::Truss& truss, const Route& route,
                          const Coordinates& start, bool free_lifts, const MotionOptions& options, std::mt19937_64& random,
                          const std::stop_token& stop) {
  return Chain(model, obstacles, truss, route, start, free_lifts, options, random, stop).run(route);
}

}  // namespace foothold::hyrecro
