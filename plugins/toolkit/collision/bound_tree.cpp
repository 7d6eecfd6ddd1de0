#include "collision/bound_tree.hpp"

#include <algorithm>
#include <numeric>

namespace foothold::collision {

Bounds bounds_of(const Capsule& capsule) {
  return grown({capsule.a.cwiseMin(capsule.b), capsule.a.cwiseMax(capsule.b)}, capsule.radius);
}

Bounds bounds_of(const Box& box) {
  const Vector3d extent = box.pose.linear().cwiseAbs() * box.half, centre = box.pose.translation();
  return {centre - extent, centre + extent};
}

Bounds bounds_of(const Patch& patch) {
  Bounds out;
  for (const Vector3d& vertex : patch.vertices) out.extend(vertex);
  return out;
}

Bounds grown(const Bounds& bounds, double by) {
  return {bounds.min() - Vector3d::Constant(by), bounds.max() + Vector3d::Constant(by)};
}

BoundTree::BoundTree(std::span<const Bounds> items) {
  std::vector<std::uint32_t> order(items.size());
  std::iota(order.begin(), order.end(), 0u);
  nodes_.reserve(2 * items.size());
  if (!items.empty()) build(items, order);
}

// Halves by number, so the depth is log2 of the number of items.
std::uint32_t BoundTree::build(std::span<const Bounds> items, std::span<std::uint32_t> order) {
  const auto self = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Bounds bounds, centres;
  for (const std::uint32_t k : order) {
    bounds.extend(items[k]);
    centres.extend(items[k].center());
  }
  nodes_[self].bounds = bounds;
  if (order.size() == 1) {
    nodes_[self].item = order.front();
    return self;
  }
  Eigen::Index axis = 0;
  centres.sizes().maxCoeff(&axis);
  const std::size_t half = order.size() / 2;
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(half), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double at_a = items[a].center()[axis], at_b = items[b].center()[axis];
                     return at_a != at_b ? at_a < at_b : a < b;
                   });
  const std::uint32_t left = build(items, order.first(half));
  const std::uint32_t right = build(items, order.subspan(half));
  nodes_[self].left = left, nodes_[self].right = right;
  return self;
}

}  // namespace foothold::collision
