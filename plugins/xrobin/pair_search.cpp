// Nearest neighbours in a uniform grid, prefixes in spatial order.
#include "pair_search.hpp"

#include <algorithm>
#include <numeric>

namespace foothold::xrobin {
namespace {

constexpr double kCell = 5e-4;            // m
constexpr double kFloatMargin = 2e-7;     // m: more than what single precision loses at this size
constexpr std::size_t kLookEvery = 2048;  // prefixes between two looks at the stop token

}  // namespace

PairSearch::PairSearch(const HalfCycles& half_cycles, int n) : half_cycles_(&half_cycles), n_(n), cell_(kCell) {
  const PoseLevel& level = half_cycles.level(n);
  const Turns& turns = half_cycles.turns();
  const std::size_t size = level.size();
  std::vector<float> x(size), y(size);
  for (std::size_t k = 0; k < size; ++k) {
    const double c = turns.cosine(level.turn[k]);
    const double s = turns.sine(level.turn[k]);
    x[k] = static_cast<float>(-c * level.x[k] - s * level.y[k]);
    y[k] = static_cast<float>(s * level.x[k] - c * level.y[k]);
    reach_ = std::max(reach_, std::hypot(level.x[k], level.y[k]));
  }
  columns_ = 2 * (static_cast<int>(reach_ / cell_) + 2);
  std::vector<std::uint32_t> cell(size);
  begin_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(columns_) + 1, 0);
  const auto index = [&](float v) { return static_cast<std::uint32_t>(v / cell_ + 0.5 * columns_); };
  for (std::size_t k = 0; k < size; ++k) {
    cell[k] = index(y[k]) * static_cast<std::uint32_t>(columns_) + index(x[k]);
    ++begin_[cell[k] + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());

  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  suffix_x_.resize(size), suffix_y_.resize(size), suffix_id_.resize(size);
  for (std::size_t k = 0; k < size; ++k) {
    const std::uint32_t to = next[cell[k]]++;
    suffix_x_[to] = x[k], suffix_y_[to] = y[k], suffix_id_[to] = static_cast<std::uint32_t>(k);
  }
  turn_begin_.assign(turns.size() + 1, 0);
  for (const std::uint16_t turn : level.turn) ++turn_begin_[turn + 1u];
  std::partial_sum(turn_begin_.begin(), turn_begin_.end(), turn_begin_.begin());
  next.assign(turn_begin_.begin(), turn_begin_.end() - 1);
  prefix_x_.resize(size), prefix_y_.resize(size), prefix_id_.resize(size);
  for (const std::uint32_t k : suffix_id_) {  // already in the order of the cells
    const std::uint32_t to = next[level.turn[k]]++;
    prefix_x_[to] = x[k], prefix_y_[to] = y[k], prefix_id_[to] = k;
  }
}

std::optional<Pair> PairSearch::closest(const Target& target, double bound, const std::stop_token& stop) const {
  const PoseLevel& level = half_cycles_->level(n_);
  const Turns& turns = half_cycles_->turns();
  std::optional<Pair> best;
  double radius = bound + kFloatMargin;
  std::size_t seen = 0;
  const auto column = [&](double v) { return std::clamp(static_cast<int>(v / cell_ + 0.5 * columns_), 0, columns_ - 1); };
  const auto try_pair = [&](std::uint32_t prefix, std::uint32_t suffix) {
    const double turn = turns.angle(level.turn[prefix]) - turns.angle(level.turn[suffix]);
    if (target.heading && std::abs(wrapped(turn - *target.heading)) > target.heading_tolerance) return;
    const PlanarPose p{level.x[prefix], level.y[prefix], turns.angle(level.turn[prefix])};
    const PlanarPose s{level.x[suffix], level.y[suffix], turns.angle(level.turn[suffix])};
    const PlanarPose end = p * inverse(s);
    const double distance = std::hypot(end.x - target.x, end.y - target.y);
    if (distance < (best ? best->distance : bound)) {
      best = Pair{prefix, suffix, distance};
      radius = distance + kFloatMargin;
    }
  };
  for (std::size_t turn = 0; turn < turns.size(); ++turn) {
    const double c = turns.cosine(turn);
    const double s = turns.sine(turn);
    const double vx = c * target.x + s * target.y;
    const double vy = -s * target.x + c * target.y;
    for (std::uint32_t k = turn_begin_[turn]; k < turn_begin_[turn + 1]; ++k) {
      if (++seen % kLookEvery == 0 && stop.stop_requested()) return std::nullopt;
      const double ux = vx + prefix_x_[k];
      const double uy = vy + prefix_y_[k];
      if (ux * ux + uy * uy > (reach_ + radius) * (reach_ + radius)) continue;
      const int left = column(ux - radius), right = column(ux + radius);
      const int bottom = column(uy - radius), top = column(uy + radius);
      for (int row = bottom; row <= top; ++row) {
        const std::size_t line = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
        const std::uint32_t end = begin_[line + static_cast<std::size_t>(right) + 1];
        for (std::uint32_t q = begin_[line + static_cast<std::size_t>(left)]; q < end; ++q) {
          const double dx = suffix_x_[q] - ux;
          const double dy = suffix_y_[q] - uy;
          if (dx * dx + dy * dy < radius * radius) try_pair(prefix_id_[k], suffix_id_[q]);
        }
      }
    }
  }
  return best;
}

Word PairSearch::word(const Pair& pair) const {
  Word word = half_cycles_->word(n_, pair.prefix);
  const Word second = half_cycles_->word(n_, pair.suffix);
  word.insert(word.end(), second.rbegin(), second.rend());
  return word;
}

double PairSearch::merge_bound() const {
  // Both halves' own, and the second half turned by the headings' error of both.
  return 2.0 * half_cycles_->merge_bound(n_) + 2.0 * half_cycles_->merge_angle(n_) * reach_;
}

}  // namespace foothold::xrobin
