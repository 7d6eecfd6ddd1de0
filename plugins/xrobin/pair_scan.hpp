// The scan over pairs: prefix clusters against the bit maps, then clusters against clusters, then points against points.
// Internal to the searches of pair_search.hpp.
#pragma once

#include <algorithm>
#include <cmath>

#include "pair_search.hpp"

namespace foothold::xrobin {

// One pass over the pairs of an index: the target as each heading sees it, and a sink for what lies within reach.
//
// Sink: double bound() const, m: pairs farther away are of no interest, may shrink; double inner() const, m: nor are pairs nearer
// than this, constant; void take(const Pair&), called for every pair in between, at least.
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
      for (std::size_t k = index_.turn_clusters[turn]; k < index_.turn_clusters[turn + 1] && !stopped_; k += stride) {
        look();
        const Cluster& cluster = index_.prefix_clusters[k];
        const float ux = vx_ + cluster.x;
        const float uy = vy_ + cluster.y;
        if (map_ == nullptr)
          visit_tree(k, ux, uy);
        else if (is_near(ux, uy))
          visit_cells(k, ux, uy);
      }
    }
  }

  bool stopped() const { return stopped_; }

 private:
  // Clusters between two looks at the stop token.
  static constexpr std::uint32_t kLookEvery = 16384;

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

  bool is_near(float x, float y) const {
    const auto column = static_cast<std::int32_t>(x * map_->per_metre + map_->offset);
    const auto row = static_cast<std::int32_t>(y * map_->per_metre + map_->offset);
    if (static_cast<std::uint32_t>(column) >= map_->columns || static_cast<std::uint32_t>(row) >= map_->columns) return false;
    const std::uint32_t bit = static_cast<std::uint32_t>(row) * map_->columns + static_cast<std::uint32_t>(column);
    return (map_->bits[bit / 32] >> (bit % 32) & 1u) != 0;
  }

  void visit_cells(std::size_t k, float ux, float uy) {
    const float around = radius_ + index_.prefix_clusters[k].spread;
    const Cells& cells = index_.cells;
    const std::uint32_t left = cells.of(ux - around), right = cells.of(ux + around);
    const std::uint32_t bottom = cells.of(uy - around), top = cells.of(uy + around);
    for (std::uint32_t row = bottom; row <= top; ++row) {
      const std::size_t line = static_cast<std::size_t>(row) * static_cast<std::size_t>(cells.columns);
      const std::uint32_t end = index_.cell_clusters[line + right + 1];
      for (std::uint32_t s = index_.cell_clusters[line + left]; s < end; ++s) try_clusters(k, s, ux, uy);
    }
  }

  void visit_tree(std::size_t k, float ux, float uy) {
    const float spread = index_.prefix_clusters[k].spread;
    index_.suffix_tree.visit(
        ux, uy, [&] { return stopped_ ? -1.0F : radius_ + spread; }, [&](std::uint32_t s) { try_clusters(k, s, ux, uy); });
  }

  void try_clusters(std::size_t prefix_cluster, std::size_t suffix_cluster, float ux, float uy) {
    look();
    const Cluster& prefix = index_.prefix_clusters[prefix_cluster];
    const Cluster& suffix = index_.suffix_clusters[suffix_cluster];
    const float dx = suffix.x - ux;
    const float dy = suffix.y - uy;
    const float most = radius_ + prefix.spread + suffix.spread;
    const float square = dx * dx + dy * dy;
    if (square > most * most) return;
    const float least = inner_ - prefix.spread - suffix.spread;
    if (least > 0.0F && square < least * least) return;
    const Points& p = index_.prefixes;
    const Points& q = index_.suffixes;
    const std::uint32_t suffix_end = index_.suffix_clusters[suffix_cluster + 1].begin;
    for (std::uint32_t k = prefix.begin; k < index_.prefix_clusters[prefix_cluster + 1].begin; ++k) {
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
  std::vector<char> allowed_, leads_to_heading_;
};

}  // namespace foothold::xrobin
