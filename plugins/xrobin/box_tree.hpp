// A tree of boxes over clusters of points: nearest neighbours at any distance, where a uniform grid would look into too many cells.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace foothold::xrobin {

// Points [begin, begin of the next cluster), all within `spread` of (x, y); m.
struct Cluster {
  float x = 0.0F;
  float y = 0.0F;
  float spread = 0.0F;
  std::uint32_t begin = 0;
};

// Immutable; any thread.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::span<const Cluster> clusters);

  // Calls visit(cluster) for every cluster that may hold a point nearer to (x, y) than radius(); nearest boxes first.
  // radius() is asked again all the time, for it may shrink. Stops early when radius() is negative.
  template <class Radius, class Visit>
  void visit(float x, float y, Radius radius, Visit visit) const {
    if (!nodes_.empty()) descend(0, x, y, radius, visit);
  }

 private:
  struct Node {
    float left, bottom, right, top;  // of all points in it
    std::uint32_t begin, end;        // in order_
    std::uint32_t second;            // second child; the first is the next node; 0: a leaf
  };

  std::uint32_t build(std::span<const Cluster> clusters, std::uint32_t begin, std::uint32_t end);

  static float square_distance(const Node& node, float x, float y) {
    const float dx = x < node.left ? node.left - x : x > node.right ? x - node.right : 0.0F;
    const float dy = y < node.bottom ? node.bottom - y : y > node.top ? y - node.top : 0.0F;
    return dx * dx + dy * dy;
  }

  template <class Radius, class Visit>
  void descend(std::uint32_t at, float x, float y, Radius& radius, Visit& visit) const {
    const Node& node = nodes_[at];
    const float most = radius();
    if (most < 0.0F || square_distance(node, x, y) > most * most) return;
    if (node.second == 0) {
      for (std::uint32_t k = node.begin; k < node.end; ++k) visit(order_[k]);
      return;
    }
    const bool swap = square_distance(nodes_[node.second], x, y) < square_distance(nodes_[at + 1], x, y);
    descend(swap ? node.second : at + 1, x, y, radius, visit);
    descend(swap ? at + 1 : node.second, x, y, radius, visit);
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace foothold::xrobin
