// Which search when, and what each of them proves.
#include "solver.hpp"

#include <algorithm>
#include <limits>

namespace foothold::xrobin {
namespace {

constexpr double kAny = 1e4;      // m: no bound on the distance
constexpr double kEqual = 1e-12;  // m: distances that differ by rounding only

double away(const Target& goal) { return std::hypot(goal.x, goal.y); }

void append(Word& word, const Word& more) { word.insert(word.end(), more.begin(), more.end()); }

}  // namespace

bool Solver::prepare(Method method, int cycles, int grid_cells, bool obstacles, const std::stop_token& stop) {
  if (method == Method::kGreedy) {
    if (!greedy_ || greedy_->cycles() != cycles || greedy_->cells() != grid_cells)
      greedy_ = std::make_unique<Greedy>(mechanism_, cycles, grid_cells);
  } else if (method != Method::kBruteForce) {
    if (!half_cycles_.grow(cycles, stop)) return false;
    for (int n = 1; n <= cycles; ++n) {
      if (stop.stop_requested()) return false;
      if (!searches_.contains(n)) searches_.emplace(n, std::make_unique<PairSearch>(half_cycles_, n));
    }
    if (obstacles && (!origins_ || origins_->levels() < cycles)) origins_ = std::make_unique<Origins>(half_cycles_, cycles);
  }
  return true;
}

Solution Solver::solve(Method method, const Target& goal, const Limits& limits, const std::stop_token& stop) const {
  Solution solution;
  switch (method) {
    case Method::kOptimal:
      solution = optimal(goal, limits, stop);
      break;
    case Method::kFewest:
      solution = fewest(goal, limits, stop);
      break;
    case Method::kGreedy:
      solution = greedy_words(goal, limits, stop);
      break;
    case Method::kBruteForce:
      solution = brute_force(goal, limits, stop);
      break;
  }
  solution.stopped = stop.stop_requested();
  // What is reported is the word's own end, not that of the pose that stands for it.
  const PlanarPose end = forward(mechanism_, solution.word);
  solution.distance = std::hypot(end.x - goal.x, end.y - goal.y);
  if (solution.proved_cycles == 0) {
    // Nothing is proved but what the longest cycle allows.
    solution.proved_cycles = limits.max_cycles;
    solution.least_distance = std::max(0.0, away(goal) - limits.max_cycles * mechanism_.longest_cycle());
  }
  const double rest = (away(goal) - limits.tolerance) / mechanism_.longest_cycle();
  solution.least_cycles = std::max(solution.least_cycles, static_cast<int>(std::ceil(rest - 1e-9)));
  return solution;
}

bool Solver::heading_met(const PlanarPose& at, const Target& goal) const {
  return !goal.heading || std::abs(wrapped(at.heading - *goal.heading)) <= goal.heading_tolerance;
}

Solution Solver::best_within(const Target& goal, int cycles, const std::stop_token& stop) const {
  Solution solution;
  const std::optional<Pair> best = search(cycles).closest(goal, kAny, stop);
  if (!best) {
    solution.possible = false;
    return solution;
  }
  solution.word = search(cycles).word(*best);
  solution.distance = best->distance;
  // A cycle of equal configurations goes nowhere, so what n cycles reach n + 1 reach too: go down until the distance grows.
  for (int n = cycles - 1; n >= 0; --n) {
    if (n == 0) {
      if (away(goal) <= best->distance + kEqual && heading_met({}, goal)) solution.word.clear(), solution.distance = away(goal);
      break;
    }
    const std::optional<Pair> fewer = search(n).closest(goal, best->distance + kEqual, stop);
    if (!fewer) break;
    solution.word = search(n).word(*fewer);
    solution.distance = fewer->distance;
  }
  solution.proved_cycles = cycles;
  solution.least_distance = std::max(0.0, best->distance - search(cycles).merge_bound());
  return solution;
}

Solution Solver::optimal(const Target& goal, const Limits& limits, const std::stop_token& stop) const {
  Solution solution = best_within(goal, std::min(limits.cycles, limits.max_cycles), stop);
  if (solution.possible && solution.distance > limits.tolerance) {
    solution.least_cycles = solution.proved_cycles + 1;
    go_farther(solution, goal, limits, stop);
  }
  return solution;
}

Solution Solver::fewest(const Target& goal, const Limits& limits, const std::stop_token& stop) const {
  const int cycles = std::min(limits.cycles, limits.max_cycles);
  if (away(goal) <= limits.tolerance && heading_met({}, goal)) return Solution{.distance = away(goal)};
  const int least = static_cast<int>(std::ceil((away(goal) - limits.tolerance) / mechanism_.longest_cycle() - 1e-9));
  for (int n = std::max(1, least); n <= cycles; ++n) {
    const double bound = std::nextafter(limits.tolerance, kAny);
    if (const std::optional<Pair> found = search(n).closest(goal, bound, stop)) {
      Solution solution{.word = search(n).word(*found), .distance = found->distance, .least_cycles = n};
      solution.proved_cycles = n;
      solution.least_distance = std::max(0.0, found->distance - search(n).merge_bound());
      return solution;
    }
    if (stop.stop_requested()) return {};
  }
  Solution solution = best_within(goal, cycles, stop);
  solution.least_cycles = cycles + 1;
  if (solution.possible) go_farther(solution, goal, limits, stop);
  return solution;
}

void Solver::go_farther(Solution& solution, const Target& goal, const Limits& limits, const std::stop_token& stop) const {
  const int cycles = std::min(limits.cycles, limits.max_cycles);
  const Target position{goal.x, goal.y, std::nullopt, 0.0};  // the heading is the last search's
  Word approach;                                             // as many whole blocks of cycles as the plan at hand allows
  PlanarPose reached;
  const int least = static_cast<int>(std::ceil((away(goal) - limits.tolerance) / mechanism_.longest_cycle()));
  for (int total = std::max(cycles + 1, least); total <= limits.max_cycles; ++total) {
    while (static_cast<int>(approach.size() / 2) + cycles <= total - cycles) {
      const Target left = seen_from(reached, position);
      const std::optional<Pair> block = search(cycles).closest(left, kAny, stop);
      if (!block) return;
      const Word word = search(cycles).word(*block);
      append(approach, word);
      reached = reached * forward(mechanism_, word);
    }
    const int more = total - cycles - static_cast<int>(approach.size() / 2);
    Word word = approach;
    PlanarPose at = reached;
    if (more > 0) {
      const std::optional<Pair> block = search(more).closest(seen_from(at, position), kAny, stop);
      if (!block) return;
      const Word step = search(more).word(*block);
      append(word, step);
      at = at * forward(mechanism_, step);
    }
    const std::optional<Pair> last = search(cycles).closest(seen_from(at, goal), solution.distance, stop);
    if (stop.stop_requested()) return;
    if (!last) continue;
    append(word, search(cycles).word(*last));
    solution.word = std::move(word);
    solution.distance = last->distance;
    solution.proved_cycles = 0;
    if (solution.distance <= limits.tolerance) return;
  }
}

Solution Solver::greedy_words(const Target& goal, const Limits& limits, const std::stop_token& stop) const {
  Solution solution{.distance = away(goal)};
  PlanarPose at;
  while (solution.distance > limits.tolerance && !stop.stop_requested()) {
    const int left = limits.max_cycles - static_cast<int>(solution.word.size() / 2);
    if (left <= 0) break;
    const Target now = seen_from(at, goal);
    Word word = greedy_->word(now.x, now.y, std::min(left, limits.cycles));
    if (limits.early_stop) word.resize(2 * cycles_to_keep(mechanism_, word, now.x, now.y, limits.tolerance));
    const PlanarPose end = forward(mechanism_, word);
    const double distance = std::hypot(end.x - now.x, end.y - now.y);
    if (distance >= solution.distance - kEqual) break;  // this way it comes no nearer
    append(solution.word, word);
    solution.distance = distance;
    at = at * end;
  }
  return solution;
}

Solution Solver::brute_force(const Target& goal, const Limits& limits, const std::stop_token& stop) const {
  Solution solution;
  const int cycles = std::min(limits.cycles, limits.max_cycles);
  const std::optional<BestWord> best = best_of_all_words(mechanism_, cycles, goal, stop);
  if (!best) {
    solution.possible = false;
    return solution;
  }
  solution.word = best->word;
  solution.distance = solution.least_distance = best->distance;
  solution.proved_cycles = cycles;
  return solution;
}

}  // namespace foothold::xrobin
