// Which of many axis-aligned boxes are near each other: sort and sweep along the axis over which they are spread widest.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace foothold::geometry {

// Calls visit(i, j) once for each pair, i != j, whose boxes come within `margin` (m) of each other along every axis. Order: by the
// sweep, the same for the same boxes.
template <class Visit>
void for_near_pairs(std::span<const Eigen::AlignedBox3d> boxes, double margin, Visit&& visit) {
  if (boxes.size() < 2) return;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), squares = Eigen::Vector3d::Zero();
  for (const auto& box : boxes) {
    sum += box.center();
    squares += box.center().cwiseAbs2();
  }
  const auto count = static_cast<double>(boxes.size());
  Eigen::Index axis = 0;
  (squares / count - (sum / count).cwiseAbs2()).maxCoeff(&axis);
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto low = [&](int i) { return boxes[static_cast<std::size_t>(i)].min()[axis]; };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return low(a) != low(b) ? low(a) < low(b) : a < b; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto& box = boxes[static_cast<std::size_t>(order[k])];
    const Eigen::Vector3d least = box.min().array() - margin, most = box.max().array() + margin;
    for (std::size_t l = k + 1; l < order.size() && low(order[l]) <= most[axis]; ++l) {
      const auto& other = boxes[static_cast<std::size_t>(order[l])];
      if ((other.min().array() <= most.array()).all() && (other.max().array() >= least.array()).all())
        visit(std::min(order[k], order[l]), std::max(order[k], order[l]));
    }
  }
}

}  // namespace foothold::geometry
