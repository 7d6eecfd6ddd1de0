// A static tree of bounds, four to a node, for the questions that are asked most: what is nearest, what touches, what a ray meets
// first.
//
// A node's bounds lie side by side, so that one instruction compares four; in single precision, rounded outwards, which may cost a
// needless look at an item and never misses one.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "collision/bound_tree.hpp"

namespace foothold::collision {

// Built once in n log n. Immutable; any thread.
class WideTree {
 public:
  using Four = Eigen::Array4f;

  // A box in single precision that holds `bounds`.
  struct Query {
    explicit Query(const Bounds& bounds);
    Eigen::Array3f low, high;
  };

  explicit WideTree(std::span<const Bounds> items);

  // Calls visit(index) for each item whose bounds touch `query` (or nearly so), in an order that depends on the tree alone; ends
  // when it returns false. Returns whether it ran to the end.
  template <class Visit>
  bool visit(const Bounds& query, Visit&& visit) const {
    const Query box(query);
    std::int32_t stack[kDeepest];
    std::size_t depth = 0;
    if (!nodes_.empty()) stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[static_cast<std::size_t>(stack[--depth])];
      const Four gaps = apart(node, box);
      for (int k = 0; k < 4; ++k) {
        if (gaps[k] > 0.0F) continue;
        if (node.child[k] >= 0)
          stack[depth++] = node.child[k];
        else if (!visit(static_cast<std::uint32_t>(~node.child[k])))
          return false;
      }
    }
    return true;
  }

  // The least of what cost(index) gives, if below `limit`, else `limit`. A cost is never below the squared distance (m^2) between
  // `query` and the item's bounds; items that cannot be the least are not asked for. Near ones first.
  template <class Cost>
  double nearest(const Bounds& query, double limit, Cost&& cost) const {
    return least([box = Query(query)](const Node& node) { return apart(node, box); }, limit, cost);
  }

  // The least of what cost(index) gives, if below `limit`, else `limit`. A cost is never below the distance (m) at which the ray
  // from `origin` along the unit vector `direction` enters the item's bounds.
  template <class Cost>
  double first(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double limit, Cost&& cost) const {
    return least([slabs = Slabs(origin, direction, greatest_)](const Node& node) { return slabs.enters(node); }, limit, cost);
  }

 private:
  static constexpr std::size_t kDeepest = 128;
  struct Node {
    Four low[3], high[3];
    std::int32_t child[4];  // another node, or ~item; where there is none, ~0 far away
  };

  struct Slabs {
    Slabs(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double greatest);
    Four enters(const Node& node) const {
      Four first = Four::Zero(), last = Four::Constant(std::numeric_limits<float>::infinity());
      for (int k = 0; k < 3; ++k) {
        const Four a = (node.low[k] - high[k]) * inverse[k], b = (node.high[k] - low[k]) * inverse[k];
        first = first.max(a.min(b)), last = last.min(a.max(b));
      }
      return (first * (1.0F - kSlack) <= last * (1.0F + kSlack))
          .select(first * (1.0F - kSlack), Four::Constant(std::numeric_limits<float>::infinity()));
    }
    Eigen::Array3f low, high, inverse;  // of the origin, widened by what single precision loses
  };

  // Squared distance of each of the four, or a little less.
  static Four apart(const Node& node, const Query& query) {
    Four sum = Four::Zero();
    for (int k = 0; k < 3; ++k) {
      const Four gap = (node.low[k] - query.high[k]).max(query.low[k] - node.high[k]).max(0.0F);
      sum += gap * gap;
    }
    return sum * (1.0F - kSlack);
  }

  template <class Lower, class Cost>
  double least(Lower&& lower, double limit, Cost&& cost) const {
    struct Open {
      float bound;
      std::int32_t child;
    } stack[kDeepest];
    std::size_t depth = 0;
    Open next{0.0F, 0};
    if (nodes_.empty()) return limit;
    for (;;) {
      if (next.child < 0) {
        limit = std::min(limit, static_cast<double>(cost(static_cast<std::uint32_t>(~next.child))));
      } else {
        const Node& node = nodes_[static_cast<std::size_t>(next.child)];
        const Four bounds = lower(node);
        const auto most = static_cast<float>(limit);  // rounded by less than kSlack
        Open best{most, -1};
        bool any = false;
        for (int k = 0; k < 4; ++k) {
          const Open here{bounds[k], node.child[k]};
          if (!(here.bound < most)) continue;
          if (any) stack[depth++] = here.bound < best.bound ? best : here;
          if (!any || here.bound < best.bound) best = here;
          any = true;
        }
        if (any) {
          next = best;
          continue;
        }
      }
      do {
        if (depth == 0) return limit;
        next = stack[--depth];
      } while (!(static_cast<double>(next.bound) < limit));
    }
  }

  static constexpr float kSlack = 2e-6F;  // what a few operations in single precision lose, in parts of the result
  std::int32_t build(std::span<const Bounds> items, std::span<std::uint32_t> order);
  std::vector<Node> nodes_;
  double greatest_ = 0.0;  // coordinate of all, m
};

}  // namespace foothold::collision
