// The scan over pairs: prefix clusters against the bit maps, then clusters against clusters, then points against points.
// Internal to the searches of pair_search.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "pair_search.hpp"

namespace foothold::xrobin {

// One pass over the pairs of an index: the target as each heading sees it, and a sink for what lies within reach.
//
// Sink: double bound() const, m: pairs farther away are of no interest, may shrink; double inner() const, m: nor are pairs nearer
// than this, constant; live(), the prefixes to look at or null for all; void take(const Pair&), called for every pair in between.
template <class Sink>
class PairScan {
 public:
  PairScan(const PoseLevel& level, const Turns& turns, const PairIndex& index, const Target& target, Sink& sink,
           const std::stop_token& stop)
      : level_(level), turns_(turns), index_(index), target_(target), sink_(sink), stop_(stop) {
    margin_ = PairIndex::kMargin * static_cast<float>(std::max(1.0, std::hypot(target.x, target.y) + index.reach));
    inner_ = static_cast<float>(sink.inner()) - margin_;
    shift_x_.resize(turns_.size());
    shift_y_.resize(turns_.size());
    for (std::size_t t = 0; t < turns_.size(); ++t) {
      shift_x_[t] = static_cast<float>(turns_.cosine(t) * target.x + turns_.sine(t) * target.y);
      shift_y_[t] = static_cast<float>(turns_.cosine(t) * target.y - turns_.sine(t) * target.x);
    }
    if (target.heading) allow_headings();
    take_radius();
  }

  // Every `stride`-th prefix cluster.
  void pass(std::size_t stride) {
    for (std::size_t turn = 0; turn < turns_.size() && !stopped_; ++turn) {
      if (target_.heading && !leads_to_heading_[turn]) continue;
      vx_ = shift_x_[turn];
      vy_ = shift_y_[turn];
      const std::size_t end = index_.turn_clusters[turn + 1];
      for (std::size_t k = index_.turn_clusters[turn]; k < end && !stopped_;)
        if (stride == 1 && map_ != nullptr)
          k = pass_block(k, std::min(end, k + kBlock));
        else
          visit(k), k += stride;
    }
  }

  bool stopped() const { return stopped_; }

 private:
  // Clusters between two looks at the stop token.
  static constexpr std::uint32_t kLookEvery = 16384;
  // Clusters that are held against one map at once; the radius, and with it the map, may shrink between two blocks.
  static constexpr std::size_t kBlock = 2048;

  std::size_t pass_block(std::size_t from, std::size_t to) {
    const NearMap& map = *map_;
    const std::size_t found =
        near_places(map, index_.prefix_x.data() + from, index_.prefix_y.data() + from, to - from, vx_, vy_, found_.data());
    if (stop_.stop_requested()) stopped_ = true;
    // In three rounds, so that the processor waits for memory once for many clusters: which cells, which suffix clusters, compare.
    const float around = radius_ + index_.widest_prefix_cluster;
    for (std::size_t i = 0; i < found; ++i) {
      const std::size_t k = from + found_[i];
      windows_[i] = window_round(vx_ + index_.prefix_x[k], vy_ + index_.prefix_y[k], around);
      __builtin_prefetch(&index_.cell_clusters[windows_[i].first]);
      __builtin_prefetch(&index_.cell_clusters[windows_[i].last]);
    }
    ranges_.clear();
    for (std::size_t i = 0; i < found; ++i) {
      const Window& window = windows_[i];
      for (std::uint32_t line = window.first; line <= window.last; line += static_cast<std::uint32_t>(index_.cells.columns)) {
        const std::uint32_t begin = index_.cell_clusters[line];
        const std::uint32_t end = index_.cell_clusters[line + window.width];
        if (begin == end) continue;
        __builtin_prefetch(&index_.suffix_clusters[begin]);
        ranges_.push_back({from + found_[i], begin, end});
      }
    }
    for (const Range& range : ranges_) {
      if (!is_live(range.prefix)) continue;
      const float ux = vx_ + index_.prefix_x[range.prefix];
      const float uy = vy_ + index_.prefix_y[range.prefix];
      for (std::uint32_t s = range.begin; s < range.end; ++s) try_clusters(range.prefix, s, ux, uy);
      if (stopped_) break;
    }
    return to;
  }

  // Cells that a square of half width `around` meets: lines of `width` cells, the first and the last beginning at these cells.
  struct Window {
    std::uint32_t first, last, width;
  };
  // Suffix clusters to be held against a prefix cluster.
  struct Range {
    std::size_t prefix;
    std::uint32_t begin, end;
  };

  Window window_round(float x, float y, float around) const {
    const Cells& cells = index_.cells;
    const std::uint32_t left = cells.of(x - around), right = cells.of(x + around);
    const std::uint32_t bottom = cells.of(y - around), top = cells.of(y + around);
    const auto columns = static_cast<std::uint32_t>(cells.columns);
    return {bottom * columns + left, top * columns + left, right - left + 1};
  }

  // Whether any of its prefixes is to be looked at.
  bool is_live(std::size_t cluster) const {
    const std::vector<char>* live = sink_.live();
    if (live == nullptr) return true;
    const auto& ids = index_.prefixes.id;
    for (std::uint32_t k = index_.prefix_clusters[cluster].begin; k < index_.prefix_clusters[cluster + 1].begin; ++k)
      if ((*live)[ids[k]]) return true;
    return false;
  }

  void visit(std::size_t k) {
    look();
    if (!is_live(k)) return;
    if (map_ == nullptr)
      visit_tree(k);
    else if (map_->at(vx_ + index_.prefix_x[k], vy_ + index_.prefix_y[k]))
      visit_cells(k);
  }

  void look() {
    if (++looks_ % kLookEvery == 0 && stop_.stop_requested()) stopped_ = true;
  }

  // Which pairs of headings end in the wanted one.
  void allow_headings() {
    const std::size_t n = turns_.size();
    allowed_.assign(n * n, 0);
    leads_to_heading_.assign(n, 0);
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t s = 0; s < n; ++s) {
        if (std::abs(wrapped(turns_.angle(p) - turns_.angle(s) - *target_.heading)) > target_.heading_tolerance) continue;
        allowed_[p * n + s] = 1;
        leads_to_heading_[p] = 1;
      }
  }

  // Sets what follows from the distance that still is of interest: search radius and map.
  void take_radius() {
    radius_ = static_cast<float>(std::min(sink_.bound(), 1e6)) + margin_;
    map_ = nullptr;
    for (const NearMap& map : index_.near)
      if (map.radius >= radius_ + index_.widest_prefix_cluster) {
        map_ = &map;
        return;
      }
  }

  void visit_cells(std::size_t k) {
    const float ux = vx_ + index_.prefix_x[k];
    const float uy = vy_ + index_.prefix_y[k];
    const Window window = window_round(ux, uy, radius_ + index_.prefix_clusters[k].spread);
    for (std::uint32_t line = window.first; line <= window.last; line += static_cast<std::uint32_t>(index_.cells.columns))
      for (std::uint32_t s = index_.cell_clusters[line]; s < index_.cell_clusters[line + window.width]; ++s)
        try_clusters(k, s, ux, uy);
  }

  void visit_tree(std::size_t k) {
    const float ux = vx_ + index_.prefix_x[k];
    const float uy = vy_ + index_.prefix_y[k];
    const float spread = index_.prefix_clusters[k].spread;
    index_.suffix_tree.visit(
        ux, uy, [&] { return stopped_ ? -1.0F : radius_ + spread; }, [&](std::uint32_t s) { try_clusters(k, s, ux, uy); });
  }

  void try_clusters(std::size_t prefix_cluster, std::size_t suffix_cluster, float ux, float uy) {
    look();
    const Cluster& suffix = index_.suffix_clusters[suffix_cluster];
    const float dx = suffix.x - ux;
    const float dy = suffix.y - uy;
    const float square = dx * dx + dy * dy;
    const float at_most = radius_ + index_.widest_prefix_cluster + suffix.spread;
    if (square > at_most * at_most) return;
    const Cluster& prefix = index_.prefix_clusters[prefix_cluster];
    const float most = radius_ + prefix.spread + suffix.spread;
    if (square > most * most) return;
    const float least = inner_ - prefix.spread - suffix.spread;
    if (least > 0.0F && square < least * least) return;
    const Points& p = index_.prefixes;
    const Points& q = index_.suffixes;
    const std::uint32_t suffix_end = index_.suffix_clusters[suffix_cluster + 1].begin;
    const std::vector<char>* live = sink_.live();
    for (std::uint32_t k = prefix.begin; k < index_.prefix_clusters[prefix_cluster + 1].begin; ++k) {
      if (live != nullptr && !(*live)[p.id[k]]) continue;
      const float px = vx_ + p.x[k];
      const float py = vy_ + p.y[k];
      for (std::uint32_t s = suffix.begin; s < suffix_end; ++s) {
        const float ex = q.x[s] - px;
        const float ey = q.y[s] - py;
        if (ex * ex + ey * ey < radius_ * radius_) take(p.id[k], q.id[s]);
      }
    }
  }

  // Judges a pair in double precision.
  void take(std::uint32_t prefix, std::uint32_t suffix) {
    const std::size_t p = level_.turn[prefix];
    const std::size_t s = level_.turn[suffix];
    if (target_.heading && !allowed_[p * turns_.size() + s]) return;
    const double qx = -turns_.cosine(s) * level_.x[suffix] - turns_.sine(s) * level_.y[suffix];
    const double qy = turns_.sine(s) * level_.x[suffix] - turns_.cosine(s) * level_.y[suffix];
    const double x = level_.x[prefix] + turns_.cosine(p) * qx - turns_.sine(p) * qy;
    const double y = level_.y[prefix] + turns_.sine(p) * qx + turns_.cosine(p) * qy;
    const double distance = std::hypot(x - target_.x, y - target_.y);
    if (distance >= sink_.bound() || distance < sink_.inner()) return;
    sink_.take(Pair{prefix, suffix, distance});
    take_radius();
  }

  const PoseLevel& level_;
  const Turns& turns_;
  const PairIndex& index_;
  const Target& target_;
  Sink& sink_;
  const std::stop_token& stop_;
  std::uint32_t looks_ = 0;
  bool stopped_ = false;
  float margin_ = 0.0F;
  float inner_ = 0.0F;
  float radius_ = 0.0F;
  const NearMap* map_ = nullptr;  // null: the radius is beyond every map
  float vx_ = 0.0F, vy_ = 0.0F;   // the target's shift at the heading at hand
  std::vector<float> shift_x_, shift_y_;
  std::array<std::uint32_t, kBlock> found_;
  std::array<Window, kBlock> windows_;
  std::vector<Range> ranges_;
  std::vector<char> allowed_, leads_to_heading_;
};

}  // namespace foothold::xrobin
