// How the tree is made, and numbers rounded outwards.
#include "collision/wide_tree.hpp"

#include <array>
#include <cmath>
#include <numeric>

namespace foothold::collision {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNowhere = 1e30F;  // m: its square is infinite

float below(double value) {
  const auto nearest = static_cast<float>(value);
  return static_cast<double>(nearest) > value ? std::nextafter(nearest, -kInfinity) : nearest;
}
float above(double value) { return -below(-value); }

// Two halves by number, split along the longest side of the bounds' centres.
std::size_t halved(std::span<const Bounds> items, std::span<std::uint32_t> order) {
  Bounds centres;
  for (const std::uint32_t k : order) centres.extend(items[k].center());
  Eigen::Index axis = 0;
  centres.sizes().maxCoeff(&axis);
  const std::size_t half = order.size() / 2;
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(half), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double at_a = items[a].center()[axis], at_b = items[b].center()[axis];
                     return at_a != at_b ? at_a < at_b : a < b;
                   });
  return half;
}

}  // namespace

WideTree::Query::Query(const Bounds& bounds) {
  for (Eigen::Index k = 0; k < 3; ++k) low[k] = below(bounds.min()[k]), high[k] = above(bounds.max()[k]);
}

WideTree::Slabs::Slabs(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double greatest) {
  const double slack = 4.0 * std::numeric_limits<float>::epsilon() * (greatest + origin.cwiseAbs().maxCoeff());
  constexpr double kLeast = 1e-20;  // instead of 0: the inverse stays finite, and the slabs are as good as parallel
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double along = std::abs(direction[k]) < kLeast ? kLeast : direction[k];
    low[k] = below(origin[k] - slack), high[k] = above(origin[k] + slack), inverse[k] = static_cast<float>(1.0 / along);
  }
}

WideTree::WideTree(std::span<const Bounds> items) {
  std::vector<std::uint32_t> order(items.size());
  std::iota(order.begin(), order.end(), 0u);
  for (const Bounds& bounds : items)
    greatest_ = std::max({greatest_, bounds.min().cwiseAbs().maxCoeff(), bounds.max().cwiseAbs().maxCoeff()});
  nodes_.reserve(items.size() / 2 + 1);
  if (!items.empty()) build(items, order);
}

std::int32_t WideTree::build(std::span<const Bounds> items, std::span<std::uint32_t> order) {
  const std::size_t self = nodes_.size();
  nodes_.emplace_back();
  std::array<std::span<std::uint32_t>, 4> parts{};
  if (order.size() <= parts.size()) {
    for (std::size_t k = 0; k < order.size(); ++k) parts[k] = order.subspan(k, 1);
  } else {
    const std::size_t half = halved(items, order);
    const auto left = order.first(half), right = order.subspan(half);
    const std::size_t in_left = halved(items, left), in_right = halved(items, right);
    parts = {left.first(in_left), left.subspan(in_left), right.first(in_right), right.subspan(in_right)};
  }
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto slot = static_cast<Eigen::Index>(k);
    Bounds bounds;
    for (const std::uint32_t item : parts[k]) bounds.extend(items[item]);
    const std::int32_t child = parts[k].empty()       ? ~0
                               : parts[k].size() == 1 ? ~static_cast<std::int32_t>(parts[k].front())
                                                      : build(items, parts[k]);
    Node& node = nodes_[self];
    node.child[k] = child;
    for (int axis = 0; axis < 3; ++axis) {
      node.low[axis][slot] = parts[k].empty() ? kNowhere : below(bounds.min()[axis]);
      node.high[axis][slot] = parts[k].empty() ? kNowhere : above(bounds.max()[axis]);
    }
  }
  return static_cast<std::int32_t>(self);
}

}  // namespace foothold::collision
