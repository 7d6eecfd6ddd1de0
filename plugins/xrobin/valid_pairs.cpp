// Batches of pairs, nearest first, until one can be walked.
#include "valid_pairs.hpp"

#include <algorithm>
#include <limits>

namespace foothold::xrobin {
namespace {

constexpr std::size_t kFirstBatch = 2048;
constexpr std::size_t kLastBatch = 32768;  // sorting more would take longer than a stop may wait
constexpr std::size_t kPatience = 3000;    // pairs
constexpr double kNearGoal = 5e-3;         // m: bodies would become too thin to be of use
constexpr double kRounding = 1e-6;         // m
constexpr double kSameEnd = 1e-10;         // m and rad

bool same(const PlanarPose& a, const PlanarPose& b) {
  return distance(a, b) < kSameEnd && std::abs(wrapped(a.heading - b.heading)) < kSameEnd;
}

}  // namespace

ValidPairs::ValidPairs(const HalfCycles& half_cycles, const Origins& origins, Passage& passage, const geometry::Geodesic& ways,
                       int most_cycles)
    : half_cycles_(&half_cycles),
      origins_(&origins),
      passage_(&passage),
      ways_(&ways),
      travel_(half_cycles.mechanism().travel()),
      forward_(half_cycles, origins, passage, most_cycles),
      backward_(half_cycles, origins, passage, most_cycles),
      most_cycles_(most_cycles) {
  const Block& a = passage.surroundings().bodies().a;
  beside_ = std::min(a.half_x, a.half_y - travel_);
}

bool ValidPairs::too_far(const PairSearch& search, const Pair& pair) {
  // An end so near to the goal keeps obstacles out of the line between them; farther ones may have a wall there.
  if (pair.distance >= beside_) return false;
  float& way = way_from_[pair.prefix];
  if (way < 0.0F) {
    const PlanarPose middle = forward_.pose(search.cycles(), pair.prefix);
    way = static_cast<float>(ways_->distance({middle.x, middle.y}));
  }
  return way > search.cycles() * travel_ + pair.distance + kRounding;
}

const std::vector<char>& ValidPairs::live_prefixes(int n) {
  live_.resize(half_cycles_->level(n).size());
  for (std::uint32_t id = 0; id < live_.size(); ++id) live_[id] = forward_.refuted(n, id) ? 0 : 1;
  return live_;
}

std::optional<Word> ValidPairs::walkable(const PairSearch& search, const Pair& pair) {
  const int n = search.cycles();
  const ConfigurationSet before = forward_.reach(n, pair.prefix);
  if (before == 0) return std::nullopt;
  const PlanarPose end = start_.a * search.end(pair);
  if (!end_planted_ || !same(end, end_)) backward_.plant(end, 0), end_ = end, end_planted_ = true;
  const ConfigurationSet after = backward_.reach(n, pair.suffix);
  const bool a_holds = n % 2 == 0;
  const PlanarPose middle = forward_.pose(n, pair.prefix);
  const auto joined = static_cast<ConfigurationSet>(before & passage_->reachable(a_holds, middle, after));
  if (joined == 0 || passage_->stopped()) return std::nullopt;
  Word word = forward_.chain(n, pair.prefix, joined);
  const auto from_there = static_cast<ConfigurationSet>(after & passage_->reachable(a_holds, middle, set_of(word.back())));
  const Word back = backward_.chain(n, pair.suffix, from_there);
  word.insert(word.end(), back.rbegin(), back.rend());
  return word;
}

ValidWord ValidPairs::nearest(const PairSearch& search, const Stance& start, const Target& goal, double bound,
                              std::size_t most_pairs, const std::stop_token& stop) {
  start_ = start;
  forward_.plant(start.a, start.configuration);
  end_planted_ = false;
  way_from_.assign(search.index().prefixes.id.size(), -1.0F);
  std::size_t seen = 0;
  const Target local = seen_from(start.a, goal);
  ValidWord out;
  const std::optional<Pair> first = search.closest(local, bound, stop);
  out.excluded_to = first ? first->distance : bound;
  out.complete = true;
  if (!first) return out;

  const Surroundings& surroundings = passage_->surroundings();
  const int n = search.cycles();
  double outer = 1.5 * first->distance + 1e-6;
  near_goal_.reset();
  const auto wanted = [&](const Pair& pair) {
    if (++seen > most_pairs || stop.stop_requested()) return false;
    // What costs little first.
    if (forward_.refuted(n, pair.prefix) || too_far(search, pair)) return false;
    const PlanarPose end = start.a * search.end(pair);
    if (!surroundings.room_for_a(end.x, end.y) || forward_.reach(n, pair.prefix) == 0) return false;
    return !near_goal_ || near_goal_->may_lead(n, pair.suffix, end);
  };
  std::size_t most = kFirstBatch;
  const std::vector<char>* live = nullptr;
  while (out.excluded_to < bound) {
    // Few pairs are judged faster one by one.
    const double farthest = std::min(outer, bound);
    if (seen > kPatience && farthest < kNearGoal && (!near_goal_ || near_goal_->radius() < farthest))
      near_goal_.emplace(*half_cycles_, *origins_, surroundings, most_cycles_, goal, start.a.heading, farthest, stop);
    if (seen > kPatience) live = &live_prefixes(n);
    const std::optional<PairBatch> batch = search.batch(local, {out.excluded_to, farthest, most, live}, wanted, stop);
    if (!batch || stop.stop_requested()) return {};
    if (seen > most_pairs) {
      out.complete = false;
      return out;
    }
    for (const Pair& pair : batch->pairs) {
      out.word = walkable(search, pair);
      if (stop.stop_requested()) return {};
      if (!out.word) continue;
      out.distance = pair.distance;
      out.excluded_to = pair.distance;
      return out;
    }
    out.excluded_to = batch->complete_to;
    if (batch->complete_to >= outer) outer *= 2.0;
    most = std::min(8 * most, kLastBatch);
  }
  return out;
}

}  // namespace foothold::xrobin
