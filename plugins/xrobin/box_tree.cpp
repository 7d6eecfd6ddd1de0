// Median splits along the longer side.
#include "box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace foothold::xrobin {
namespace {

constexpr std::uint32_t kLeaf = 8;

}  // namespace

BoxTree::BoxTree(std::span<const Cluster> clusters) : order_(clusters.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  if (!clusters.empty()) build(clusters, 0, static_cast<std::uint32_t>(clusters.size()));
}

std::uint32_t BoxTree::build(std::span<const Cluster> clusters, std::uint32_t begin, std::uint32_t end) {
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  const Cluster& first = clusters[order_[begin]];
  Node node{first.x, first.y, first.x, first.y, begin, end, 0};
  for (std::uint32_t k = begin; k < end; ++k) {
    const Cluster& c = clusters[order_[k]];
    node.left = std::min(node.left, c.x - c.spread), node.right = std::max(node.right, c.x + c.spread);
    node.bottom = std::min(node.bottom, c.y - c.spread), node.top = std::max(node.top, c.y + c.spread);
  }
  nodes_.push_back(node);
  if (end - begin <= kLeaf) return at;
  const bool wide = node.right - node.left > node.top - node.bottom;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](std::uint32_t a, std::uint32_t b) {
    const float va = wide ? clusters[a].x : clusters[a].y;
    const float vb = wide ? clusters[b].x : clusters[b].y;
    return va != vb ? va < vb : a < b;
  });
  build(clusters, begin, middle);
  const std::uint32_t second = build(clusters, middle, end);
  nodes_[at].second = second;
  return at;
}

}  // namespace foothold::xrobin
