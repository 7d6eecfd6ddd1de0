// Sinks of the scan: the nearest pair, and the nearest many.
#include "pair_search.hpp"

#include <algorithm>

#include "pair_scan.hpp"

namespace foothold::xrobin {
namespace {

constexpr double kFirstBound = 2e-3;  // m

class Nearest {
 public:
  explicit Nearest(double bound) : bound_(bound) {}
  double bound() const { return bound_; }
  static double inner() { return 0.0; }
  static const std::vector<char>* live() { return nullptr; }
  void take(const Pair& pair) {
    best = pair;
    bound_ = pair.distance;
  }
  std::optional<Pair> best;

 private:
  double bound_;
};

class NearestMany {
 public:
  NearestMany(const PairRange& range, const std::function<bool(const Pair&)>& wanted)
      : range_(range), wanted_(wanted), bound_(range.outer) {}
  double bound() const { return bound_; }
  double inner() const { return range_.inner; }
  const std::vector<char>* live() const { return range_.live; }

  void take(const Pair& pair) {
    if (!wanted_(pair)) return;
    pairs_.push_back(pair);
    if (pairs_.size() >= 2 * range_.most) cut();
  }

  PairBatch finish() {
    if (pairs_.size() > range_.most) cut();
    std::sort(pairs_.begin(), pairs_.end(), before);
    return {std::move(pairs_), bound_};
  }

 private:
  static bool before(const Pair& a, const Pair& b) {
    if (a.distance != b.distance) return a.distance < b.distance;
    return a.prefix != b.prefix ? a.prefix < b.prefix : a.suffix < b.suffix;
  }

  // Keeps the nearest; all that are as far as the last of them go, so that what is kept is complete.
  void cut() {
    std::nth_element(pairs_.begin(), pairs_.begin() + static_cast<std::ptrdiff_t>(range_.most), pairs_.end(), before);
    const double farthest = pairs_[range_.most].distance;
    const auto kept = std::remove_if(pairs_.begin(), pairs_.end(), [&](const Pair& p) { return p.distance >= farthest; });
    if (kept == pairs_.begin()) {
      // More pairs end in one place than are wanted: they must all be taken.
      range_.most *= 2;
      return;
    }
    pairs_.erase(kept, pairs_.end());
    bound_ = farthest;
  }

  PairRange range_;
  const std::function<bool(const Pair&)>& wanted_;
  double bound_;
  std::vector<Pair> pairs_;
};

}  // namespace

Target seen_from(const PlanarPose& from, const Target& goal) {
  const PlanarPose at = inverse(from) * PlanarPose{goal.x, goal.y, 0.0};
  Target out{at.x, at.y, std::nullopt, goal.heading_tolerance};
  if (goal.heading) out.heading = wrapped(*goal.heading - from.heading);
  return out;
}

PairSearch::PairSearch(const HalfCycles& half_cycles, int n)
    : half_cycles_(&half_cycles), n_(n), index_(half_cycles.level(n), half_cycles.turns(), half_cycles.mechanism().travel()) {}

std::optional<Pair> PairSearch::closest(const Target& target, double bound, const std::stop_token& stop) const {
  // Where `bound` says little, small ones are tried first: with a heading wanted, few of the points near by are of use.
  for (double tried = std::min(bound, kFirstBound);; tried = std::min(bound, 8.0 * tried)) {
    Nearest nearest(tried);
    PairScan scan(half_cycles_->level(n_), half_cycles_->turns(), index_, target, nearest, stop);
    // A few clusters first: the nearest of a sample makes the radius small for all the others.
    for (const std::size_t stride : {512u, 32u, 1u}) scan.pass(stride);
    if (scan.stopped()) return std::nullopt;
    if (nearest.best || tried == bound) return nearest.best;
  }
}

std::optional<PairBatch> PairSearch::batch(const Target& target, const PairRange& range,
                                           const std::function<bool(const Pair&)>& wanted, const std::stop_token& stop) const {
  NearestMany nearest(range, wanted);
  PairScan scan(half_cycles_->level(n_), half_cycles_->turns(), index_, target, nearest, stop);
  scan.pass(1);
  if (scan.stopped()) return std::nullopt;
  return nearest.finish();
}

PlanarPose PairSearch::end(const Pair& pair) const {
  const PoseLevel& level = half_cycles_->level(n_);
  const auto at = [&](std::uint32_t id) {
    return PlanarPose{level.x[id], level.y[id], half_cycles_->turns().angle(level.turn[id])};
  };
  return at(pair.prefix) * inverse(at(pair.suffix));
}

Word PairSearch::word(const Pair& pair) const {
  Word word = half_cycles_->word(n_, pair.prefix);
  const Word second = half_cycles_->word(n_, pair.suffix);
  word.insert(word.end(), second.rbegin(), second.rend());
  return word;
}

double PairSearch::merge_bound() const {
  // Both halves' own, and the second half turned by the headings' error of both.
  return 2.0 * half_cycles_->merge_bound(n_) + 2.0 * half_cycles_->merge_angle(n_) * index_.reach;
}

}  // namespace foothold::xrobin
