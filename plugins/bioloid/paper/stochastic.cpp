// The stochastic method, rule by rule (Bioloid paper, section II.D; Figures 8, 12 and 13).
//
//   1 Direction      Every joint advances towards its goal: forward if that is greater or equal, else back.
//   2 Retirement     A joint that has arrived is excluded.
//   3 Hole           At an invalid point the step is made greater, to land on a valid point beyond it.
//   4 Detour         Else the last valid point is kept, the joint that is farthest from its goal found, and the retired joints
//                    are set moving in random directions, beyond their goals, within limits, until the farthest joint's value
//                    differs from the kept one; then the directions are computed anew.
//   5 Best approach  At every invalid point the path so far is kept if more joints have arrived than in the one kept before;
//                    it is taken up again when no advance is possible.
//
// Taken so, where the paper does not say:
// - All joints that are underway advance in the same iteration. The farthest joint is the one with the most steps left, for it
//   "requires the greatest number of iterations".
// - The hole comes before the detour; the greater step has up to Options::growth steps, and must be valid by Space::moves.
// - While the farthest joint is blocked, the others underway go on: without that nothing would move where no joint has arrived.
//   In order: all together; the farthest with the wandering ones; the farthest alone; the others with the wandering ones; the
//   wandering ones alone. The first that is valid is done. Each one judged is an iteration.
// - A random direction is kept while it can be followed, turned at a limit, and drawn anew for all wandering joints when nothing
//   was valid (an iteration too): of the three choices of the random method, for some may have to stay, until the next iteration.
// - "No advance is possible": a detour has lasted Options::patience iterations.
// - Of approaches with equally many arrived joints, the one with fewer iterations left is nearer. One that is taken up again
//   without a better one since is a dead end, into which the rules would lead for ever: it loses its last 1, 2, 4, ... points,
//   down to the start and again from 1, and all joints but the farthest wander for as many iterations before they advance.
#include <algorithm>
#include <cmath>
#include <span>

#include "bioloid/paper/methods.hpp"

namespace foothold::bioloid::paper {
namespace {

class Search {
 public:
  Search(const Space& space, const Point& start, const Point& goal, const Options& options, std::mt19937_64& random,
         std::stop_token stop)
      : space_(space),
        goal_(goal),
        options_(options),
        random_(random),
        stop_(std::move(stop)),
        path_{start},
        best_{.path = {start}} {}

  Plan run() {
    while (here() != goal_ && may_go_on()) {
      if (go(advanced(space_, here(), goal_, towards_goal()))) continue;
      remember_approach();
      if (!jump_hole() && !go_round()) take_up_best_approach();
    }
    if (here() != goal_) return std::move(plan_);
    plan_.ending = Ending::kReached;
    plan_.path = std::move(path_);
    return std::move(plan_);
  }

 private:
  struct Approach {
    std::vector<Point> path;
    int arrived = -1;
    double left = 0.0;         // iterations, summed over the joints
    std::size_t set_back = 0;  // points that it loses when it is taken up again
  };

  const Point& here() const { return path_.back(); }
  bool arrived(int joint) const { return here()[joint] == goal_[joint]; }
  double iterations_left(int joint) const { return std::abs(goal_[joint] - here()[joint]) / space_.step[joint]; }

  bool may_go_on() {
    if (stop_.stop_requested()) plan_.ending = Ending::kStopped;
    return plan_.ending != Ending::kStopped && plan_.iterations < options_.iterations;
  }

  // One iteration: the point is judged, and taken if it is valid.
  bool go(const Point& next) {
    ++plan_.iterations;
    if (!space_.moves(here(), next)) return false;
    path_.push_back(next);
    return true;
  }

  // Rules 1 and 2.
  Directions towards_goal() const {
    Directions out(space_.dimension());
    for (int k = 0; k < out.size(); ++k) out[k] = arrived(k) ? 0 : goal_[k] >= here()[k] ? 1 : -1;
    return out;
  }

  // Rule 3.
  bool jump_hole() {
    for (int times = 2; times <= options_.growth && may_go_on(); ++times)
      if (go(advanced(space_, here(), goal_, towards_goal(), times))) return ++plan_.jumps, true;
    return false;
  }

  int farthest() const {
    int out = 0;
    for (int k = 1; k < space_.dimension(); ++k)
      if (iterations_left(k) > iterations_left(out)) out = k;
    return out;
  }

  // Rule 4. False if no advance is possible.
  bool go_round() {
    const int joint = farthest();
    const double kept = here()[joint];
    const std::size_t begin = plan_.iterations;
    Wandering set(space_.dimension());
    while (plan_.iterations < begin + options_.patience && may_go_on()) {
      for (int k = 0; k < space_.dimension(); ++k)
        if (k != joint && (arrived(k) || set.wanders[k] != 0)) start_to_wander(set, k);
      turn_at_limits(set);
      const Directions& wander = set.way;
      const Directions towards = towards_goal();
      Directions farthest_only = Directions::Zero(space_.dimension()), others = towards;
      farthest_only[joint] = towards[joint];
      others[joint] = 0;
      for (int k = 0; k < wander.size(); ++k)
        if (set.wanders[k] != 0) others[k] = 0;
      const Directions together[] = {farthest_only + others + wander, farthest_only + wander, farthest_only, others + wander,
                                     wander};
      if (!go_first_of(together)) draw_again(set);
      if (here()[joint] != kept) return true;
    }
    return false;
  }

  bool go_first_of(std::span<const Directions> ways) {
    for (std::size_t k = 0; k < ways.size() && may_go_on(); ++k) {
      const bool new_one = !ways[k].isZero() && std::find(ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(k), ways[k]) ==
                                                    ways.begin() + static_cast<std::ptrdiff_t>(k);
      if (new_one && go(advanced(space_, here(), goal_, ways[k]))) return true;
    }
    return false;
  }

  struct Wandering {
    explicit Wandering(int dimension) : wanders(Directions::Zero(dimension)), way(Directions::Zero(dimension)) {}
    Directions wanders;  // 1: this joint
    Directions way;
  };

  int one_of_three() { return static_cast<int>(random_() % 3) - 1; }

  // A joint that stays is drawn anew every time, or it might stay for ever while others move.
  void start_to_wander(Wandering& set, int joint) {
    if (set.wanders[joint] == 0) set.way[joint] = (random_() & 1) != 0 ? 1 : -1;
    if (set.wanders[joint] != 0 && set.way[joint] == 0) set.way[joint] = one_of_three();
    set.wanders[joint] = 1;
  }

  void draw_again(Wandering& set) {
    ++plan_.iterations;  // so that a detour ends on which nothing is left to be judged
    for (int k = 0; k < set.way.size(); ++k)
      if (set.wanders[k] != 0) set.way[k] = one_of_three();
  }

  void turn_at_limits(Wandering& set) const {
    const auto leaves = [&](int k, int direction) {
      const double next = here()[k] + direction * space_.step[k];
      return next < space_.low[k] || next > space_.high[k];
    };
    for (int k = 0; k < set.way.size(); ++k)
      if (set.way[k] != 0 && leaves(k, set.way[k])) set.way[k] = leaves(k, -set.way[k]) ? 0 : -set.way[k];
  }

  // Rule 5.
  void remember_approach() {
    int count = 0;
    double left = 0.0;
    for (int k = 0; k < space_.dimension(); ++k) {
      count += arrived(k);
      left += iterations_left(k);
    }
    if (count > best_.arrived || (count == best_.arrived && left < best_.left)) best_ = {path_, count, left, 0};
  }

  void take_up_best_approach() {
    const std::size_t lost = std::min(best_.set_back, best_.path.size() - 1);
    best_.set_back = lost + 1 == best_.path.size() ? 1 : std::max<std::size_t>(1, 2 * best_.set_back);
    path_ = best_.path;
    path_.resize(path_.size() - lost);
    ++plan_.returns;
    wander_before_advancing(lost);
  }

  void wander_before_advancing(std::size_t iterations) {
    const int joint = farthest();
    Wandering set(space_.dimension());
    for (std::size_t k = 0; k < iterations && may_go_on(); ++k) {
      for (int other = 0; other < space_.dimension(); ++other)
        if (other != joint) start_to_wander(set, other);
      turn_at_limits(set);
      if (set.way.isZero() || !go(advanced(space_, here(), goal_, set.way))) draw_again(set);
    }
  }

  const Space& space_;
  const Point& goal_;
  const Options& options_;
  std::mt19937_64& random_;
  const std::stop_token stop_;
  std::vector<Point> path_;
  Approach best_;
  Plan plan_;
};

}  // namespace

Plan stochastic(const Space& space, const Point& start, const Point& goal, const Options& options, std::mt19937_64& random,
                std::stop_token stop) {
  return Search(space, start, goal, options, random, std::move(stop)).run();
}

}  // namespace foothold::bioloid::paper
