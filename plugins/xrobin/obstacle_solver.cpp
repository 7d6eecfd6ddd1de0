// Methods among obstacles, and what each of them proves.
#include "obstacle_solver.hpp"

#include <algorithm>

namespace foothold::xrobin {
namespace {

constexpr double kAny = 1e4;  // m: no bound on the distance
constexpr std::size_t kMostCorners = 400;
constexpr double kMostThinner = 8e-3;  // m
constexpr double kEqual = 1e-12;       // m: distances that differ by rounding only

int cycles_of(const Word& word) { return static_cast<int>(word.size() / 2); }

void append(Word& word, const Word& more) { word.insert(word.end(), more.begin(), more.end()); }

// None if there are so many corners that shortest ways among them would take longer to find than they save: a way past nothing is a
// lower bound too.
std::vector<geometry::Polygon> polygons(const std::vector<geometry::Obstacle>& obstacles) {
  std::vector<geometry::Polygon> out;
  std::size_t corners = 0;
  for (const geometry::Obstacle& obstacle : obstacles) {
    out.push_back(obstacle.polygon);
    corners += obstacle.polygon.size();
  }
  if (corners > kMostCorners) out.clear();
  return out;
}

}  // namespace

ObstacleSolver::ObstacleSolver(const Solver& solver, Passage& passage, const Stance& start, const Target& goal,
                               const Limits& limits, const ObstacleLimits& obstacle_limits, std::stop_token stop)
    : solver_(solver),
      mechanism_(solver.mechanism()),
      passage_(passage),
      start_(start),
      goal_(goal),
      limits_(limits),
      obstacle_limits_(obstacle_limits),
      stop_(std::move(stop)),
      ways_({goal.x, goal.y}, polygons(passage.surroundings().obstacles()), stop_) {
  limits_.cycles = std::min(limits_.cycles, limits_.max_cycles);
}

Solution ObstacleSolver::solve(Method method) {
  if (method == Method::kOptimal || method == Method::kFewest)
    pairs_.emplace(solver_.half_cycles(), *solver_.origins(), passage_, ways_, limits_.cycles);
  Solution solution;
  switch (method) {
    case Method::kOptimal:
      solution = optimal();
      break;
    case Method::kFewest:
      solution = fewest();
      break;
    case Method::kGreedy:
      solution = greedy_words();
      break;
    case Method::kBruteForce:
      solution = brute_force();
      break;
  }
  solution.stopped = stop_.stop_requested();
  solution.distance = away(after(start_, solution.word).a);
  const double straight = away(start_.a);
  if (solution.proved_cycles == 0) {
    solution.proved_cycles = limits_.max_cycles;
    solution.least_distance = std::max(0.0, straight - limits_.max_cycles * mechanism_.longest_cycle());
  }
  solution.least_cycles = std::max(solution.least_cycles, least_cycles());
  solution.no_way = solution.distance > limits_.tolerance && std::isinf(ways_.distance({start_.a.x, start_.a.y}));
  return solution;
}

bool ObstacleSolver::heading_met(const PlanarPose& at) const {
  return !goal_.heading || std::abs(wrapped(at.heading - *goal_.heading)) <= goal_.heading_tolerance;
}

Stance ObstacleSolver::after(const Stance& from, const Word& word) const {
  return {from.a * forward(mechanism_, word), word.empty() ? from.configuration : word.back()};
}

ValidWord ObstacleSolver::best_within(const Stance& from, int cycles, double bound, std::size_t most_pairs) {
  ValidWord best = pairs_->nearest(solver_.search(cycles), from, goal_, bound, most_pairs, stop_);
  best.excluded_to -= solver_.search(cycles).merge_bound();
  for (int n = cycles - 1; best.word && n >= 0; --n) {
    if (n == 0) {
      if (away(from.a) <= best.distance + kEqual && heading_met(from.a)) best.word = Word{};
      break;
    }
    const ValidWord fewer = pairs_->nearest(solver_.search(n), from, goal_, best.distance + kEqual, most_pairs, stop_);
    if (!fewer.word) break;
    best.word = fewer.word;
  }
  return best;
}

ValidWord ObstacleSolver::fewest_within(const Stance& from, int cycles, double bound) {
  if (away(from.a) < bound && heading_met(from.a)) return {Word{}, away(from.a), 0.0, true};
  ValidWord found;
  bool complete = true;
  for (int n = 1; n <= cycles && !stop_.stop_requested(); ++n) {
    if (away(from.a) - n * mechanism_.longest_cycle() >= bound) continue;
    found = pairs_->nearest(solver_.search(n), from, goal_, bound, obstacle_limits_.most_pairs, stop_);
    complete = complete && (found.complete || found.word.has_value());
    if (found.word) break;
  }
  found.complete = complete;
  return found;
}

int ObstacleSolver::least_cycles() const {
  const Block& a = passage_.surroundings().bodies().a;
  double way = away(start_.a);
  // Where a body that stands at the goal leaves room between them, the centres of the bodies walk a way of a point (ValidPairs).
  if (limits_.tolerance < std::min(a.half_x, a.half_y - mechanism_.travel()))
    way = std::max(way, ways_.distance({start_.a.x, start_.a.y}));
  const double cycles = std::ceil((way - limits_.tolerance) / mechanism_.longest_cycle() - 1e-6);
  return static_cast<int>(std::clamp(cycles, 0.0, limits_.max_cycles + 1.0));
}

bool ObstacleSolver::room_at_goal() const {
  // A robot that is thinner by as much as an end of a plan may differ from the goal in place and heading finds room at the goal
  // itself wherever the true one does near it.
  const double eighth = 0.25 * std::numbers::pi;
  const double off = std::max(std::abs(mechanism_.eighth_turn() - eighth), std::abs(mechanism_.quarter_turn() - 2.0 * eighth));
  const Surroundings& true_one = passage_.surroundings();
  const double arm = mechanism_.travel() + std::hypot(true_one.bodies().b.half_x, true_one.bodies().b.half_y) +
                     std::hypot(true_one.bodies().a.half_x, true_one.bodies().a.half_y);
  const double by = limits_.tolerance + 2.0 * limits_.max_cycles * off * arm;
  if (by > kMostThinner) return true;
  const Surroundings thin(true_one.ring(), thinner(true_one.bodies(), by), true_one.obstacles(), true_one.clearance());
  for (int k = 0; k < 8; ++k) {
    const PlanarPose a{goal_.x, goal_.y, start_.a.heading + k * eighth};
    for (int c = 1; c <= kConfigurations; ++c)
      if (thin.clear_at_rest({a, a * mechanism_.b_in_a(c)})) return true;
  }
  return false;
}

Solution ObstacleSolver::optimal() {
  Solution solution{.distance = away(start_.a)};
  solution.no_room = !room_at_goal();
  const bool no_more = limits_.cycles == limits_.max_cycles;
  // If more cycles may be taken, only what meets the tolerance with these is of interest.
  const double bound = no_more ? kAny : std::nextafter(limits_.tolerance, kAny);
  if (no_more || (!solution.no_room && least_cycles() <= limits_.cycles)) {
    ValidWord best = best_within(start_, limits_.cycles, bound, obstacle_limits_.most_pairs);
    if (!best.word && best.complete && no_more && !stop_.stop_requested()) {
      solution.possible = false;
      return solution;
    }
    if (best.excluded_to > limits_.tolerance) solution.least_cycles = limits_.cycles + 1;
    if (best.word || no_more) {
      solution.proved_cycles = limits_.cycles;
      solution.least_distance = std::max(0.0, best.excluded_to);
    }
    if (best.word) solution.word = std::move(*best.word), solution.distance = best.distance;
    if (best.word || stop_.stop_requested()) return solution;
  }
  go_farther(solution, Method::kOptimal);
  return solution;
}

Solution ObstacleSolver::fewest() {
  Solution solution{.distance = away(start_.a)};
  solution.no_room = !room_at_goal();
  const double bound = std::nextafter(limits_.tolerance, kAny);
  solution.least_cycles = least_cycles();
  if (!solution.no_room && solution.least_cycles <= limits_.cycles) {
    ValidWord found = fewest_within(start_, limits_.cycles, bound);
    if (found.word) {
      solution.word = std::move(*found.word);
      solution.distance = found.distance;
      if (found.complete) solution.least_cycles = cycles_of(solution.word);
      return solution;
    }
    if (found.complete) solution.least_cycles = limits_.cycles + 1;
  }
  if (!stop_.stop_requested()) go_farther(solution, Method::kFewest);
  return solution;
}

void ObstacleSolver::go_farther(Solution& solution, Method method) {
  const PathField field(passage_.surroundings(), {start_.a.x, start_.a.y}, {goal_.x, goal_.y}, stop_);
  if (stop_.stop_requested()) return;
  Approach approach(mechanism_, passage_, field, start_, limits_.max_cycles);
  const double met = std::nextafter(limits_.tolerance, kAny);
  const auto take = [&](int node, const ValidWord& last) {
    if (!last.word || last.distance >= solution.distance) return;
    solution.word = approach.word(node);
    append(solution.word, *last.word);
    solution.distance = last.distance;
    solution.proved_cycles = 0;
  };
  // From afar first: the exact search reaches so much farther than the approach must go, and fewer pairs end near the goal.
  for (double near = 0.7 * limits_.cycles * mechanism_.longest_cycle(); near > 0.02; near *= 0.6) {
    const int node = approach.go_on(near, obstacle_limits_.most_nodes);
    if (node < 0 || stop_.stop_requested()) break;
    if (solution.no_room) continue;
    const int left = std::min(limits_.cycles, limits_.max_cycles - approach.cycles(node));
    if (left <= 0) break;
    const Stance& from = approach.stance(node);
    take(node,
         method == Method::kFewest ? fewest_within(from, left, met) : best_within(from, left, met, obstacle_limits_.most_pairs));
    if (solution.distance <= limits_.tolerance || stop_.stop_requested()) return;
  }
  // The tolerance cannot be met this way: as near as possible then.
  const int nearest = approach.nearest();
  if (heading_met(approach.stance(nearest).a)) take(nearest, {Word{}, away(approach.stance(nearest).a), 0.0, true});
  const int left = std::min(limits_.cycles, limits_.max_cycles - approach.cycles(nearest));
  if (left > 0) take(nearest, best_within(approach.stance(nearest), left, solution.distance, obstacle_limits_.most_pairs / 10));
}

Solution ObstacleSolver::greedy_words() {
  Solution solution{.distance = away(start_.a)};
  Stance at = start_;
  while (solution.distance > limits_.tolerance && !stop_.stop_requested()) {
    const int left = limits_.max_cycles - cycles_of(solution.word);
    if (left <= 0) break;
    const Target now = seen_from(at.a, goal_);
    Word word = solver_.greedy().word(
        now.x, now.y, std::min(left, limits_.cycles), [&](const PlanarPose& a, int before) -> Greedy::Possible {
          // What the robot can do from here: a ring for body A, and one for body B at each place that it can get to.
          const PlanarPose held = at.a * a;
          Greedy::Possible seconds{};
          const ConfigurationSet firsts = passage_.reachable(true, held, set_of(before == 0 ? at.configuration : before));
          for (int first = 1; first <= kConfigurations; ++first)
            if (holds(firsts, first))
              seconds[static_cast<std::size_t>(first - 1)] =
                  passage_.reachable(false, held * mechanism_.b_in_a(first), set_of(first));
          return seconds;
        });
    if (limits_.early_stop) word.resize(2 * cycles_to_keep(mechanism_, word, now.x, now.y, limits_.tolerance));
    const Stance end = after(at, word);
    if (away(end.a) >= solution.distance - kEqual) break;
    append(solution.word, word);
    solution.distance = away(end.a);
    at = end;
  }
  return solution;
}

Solution ObstacleSolver::brute_force() {
  Solution solution;
  const std::optional<BestWord> best = best_of_all_walkable_words(mechanism_, passage_, start_, limits_.cycles, goal_, stop_);
  solution.possible = best.has_value();
  if (!best) return solution;
  solution.word = best->word;
  solution.least_distance = best->distance;
  solution.proved_cycles = limits_.cycles;
  return solution;
}

std::optional<Route> clear_ways(const Mechanism& mechanism, Passage& passage, const Stance& start, const Word& word) {
  Route route;
  BodyPoses now{start.a, start.a * mechanism.b_in_a(start.configuration)};
  int from = start.configuration;
  for (std::size_t k = 0; k < word.size(); ++k) {
    const bool a_holds = k % 2 == 0;
    const std::optional<RingWay> way = passage.way(a_holds, a_holds ? now.a : now.b, from, word[k]);
    if (!way) return std::nullopt;
    route.push_back({word[k], *way});
    from = word[k];
    if (a_holds)
      now.b = now.a * mechanism.b_in_a(from);
    else
      now.a = now.b * inverse(mechanism.b_in_a(from));
  }
  return route;
}

}  // namespace foothold::xrobin
