// Broad phase: a static binary tree of axis-parallel bounds, which names the few that a query touches.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "collision/distance.hpp"

namespace foothold::collision {

using Bounds = Eigen::AlignedBox3d;

// m; world axes.
Bounds bounds_of(const Capsule& capsule);
Bounds bounds_of(const Box& box);
Bounds bounds_of(const Patch& patch);
// Every side moved out by `by`, m.
Bounds grown(const Bounds& bounds, double by);

// Built once in n log n, split in the middle of the longest side by the bounds' centres. Immutable; any thread.
class BoundTree {
 public:
  explicit BoundTree(std::span<const Bounds> items);

  // Calls visit(index) for each item whose bounds touch `query`, in an order that depends on the tree alone; ends when it returns
  // false. Returns whether it ran to the end.
  template <class Visit>
  bool visit(const Bounds& query, Visit&& visit) const {
    std::uint32_t stack[kDeepest];
    std::size_t depth = 0;
    if (!nodes_.empty()) stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (!node.bounds.intersects(query)) continue;
      if (node.item != kInner) {
        if (!visit(node.item)) return false;
        continue;
      }
      stack[depth++] = node.right;
      stack[depth++] = node.left;
    }
    return true;
  }

  // The least of what cost(index) gives for the items, if below `limit`, else `limit`. lower(bounds) is never above the cost of an
  // item within those bounds; items that cannot be the least are not asked for. Near ones first.
  template <class Lower, class Cost>
  double least(double limit, Lower&& lower, Cost&& cost) const {
    struct Open {
      double bound;
      std::uint32_t node;
    } stack[kDeepest];
    std::size_t depth = 0;
    if (!nodes_.empty()) stack[depth++] = {lower(nodes_[0].bounds), 0};
    while (depth > 0) {
      const Open open = stack[--depth];
      if (!(open.bound < limit)) continue;
      const Node& node = nodes_[open.node];
      if (node.item != kInner) {
        limit = std::min(limit, static_cast<double>(cost(node.item)));
        continue;
      }
      Open left{lower(nodes_[node.left].bounds), node.left}, right{lower(nodes_[node.right].bounds), node.right};
      if (left.bound < right.bound) std::swap(left, right);
      stack[depth++] = left;
      stack[depth++] = right;
    }
    return limit;
  }

 private:
  static constexpr std::uint32_t kInner = UINT32_MAX;
  static constexpr std::size_t kDeepest = 64;
  struct Node {
    Bounds bounds;
    std::uint32_t item = kInner, left = 0, right = 0;
  };
  std::uint32_t build(std::span<const Bounds> items, std::span<std::uint32_t> order);
  std::vector<Node> nodes_;
};

}  // namespace foothold::collision
