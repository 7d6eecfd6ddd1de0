// One level of merged poses laid out for the search of pairs: the points q of all poses, once as prefixes and once as suffixes.
//
// Points are grouped into clusters, each the points of one small square: prefixes of one heading, so that one shift by the target
// moves the whole cluster, suffixes of any heading. Bit maps at several scales say whether any suffix lies near a place; most
// prefix clusters end at one look at a bit. Single precision throughout: kMargin is more than what that loses within a metre.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "box_tree.hpp"
#include "half_cycles.hpp"
#include "near_map.hpp"

namespace foothold::xrobin {

struct Points {
  std::vector<float> x, y;
  std::vector<std::uint32_t> id;  // of the pose in its level
};

// Square cells round the origin. A place beyond the grid counts as in its outermost cells.
struct Cells {
  double size = 0.0;  // m
  int columns = 0;    // and rows
  std::uint32_t of(double v) const {
    const double k = v / size + 0.5 * columns;
    return k <= 0.0 ? 0 : k >= columns - 1 ? static_cast<std::uint32_t>(columns - 1) : static_cast<std::uint32_t>(k);
  }
};

// Immutable; any thread.
struct PairIndex {
  static constexpr float kMargin = 2e-7F;  // m
  static constexpr int kScales = 6;

  // `travel`: of the slot, in m; squares and cells are sized to it.
  PairIndex(const PoseLevel& level, const Turns& turns, double travel);

  double reach = 0.0;                        // greatest |q|, m
  std::vector<Cluster> prefix_clusters;      // by heading, then place; one more at the end
  std::vector<float> prefix_x, prefix_y;     // of the prefix clusters once more, side by side for the scan
  std::vector<std::uint32_t> turn_clusters;  // first cluster of each heading; one more at the end
  Points prefixes;
  Cells cells;                               // of the suffix clusters
  std::vector<std::uint32_t> cell_clusters;  // first cluster of each cell, row by row; one more at the end
  std::vector<Cluster> suffix_clusters;      // one more at the end
  Points suffixes;
  BoxTree suffix_tree;                 // over the suffix clusters
  std::array<NearMap, kScales> near;   // fine to coarse
  float widest_prefix_cluster = 0.0F;  // greatest spread, m
};

}  // namespace foothold::xrobin
