// The planar workspace's positions in the order of their distance from a point: WS_sort of algorithm 2, by a k-d tree as in the
// paper.
#pragma once

#include <functional>
#include <memory>

#include "hyrecro/reach/planar_workspace.hpp"

namespace foothold::hyrecro {

// Immutable after construction; any thread.
class WorkspaceOrder {
 public:
  explicit WorkspaceOrder(std::shared_ptr<const PlanarWorkspace> workspace);
  ~WorkspaceOrder();

  const PlanarWorkspace& workspace() const { return *workspace_; }
  Eigen::Vector2d position(const PlanarWorkspace::Cell& cell) const;  // m, seen from the foot that holds
  // Calls `take` with the cells, nearest to `point` first, until it returns true; false if it never does.
  bool nearest_first(const Eigen::Vector2d& point, const std::function<bool(const PlanarWorkspace::Cell&)>& take) const;
  // Distance of the nearest cell from the foot that holds, m.
  double least_reach() const { return least_reach_; }

 private:
  struct Tree;
  std::shared_ptr<const PlanarWorkspace> workspace_;
  std::unique_ptr<const Tree> tree_;
  double least_reach_ = 0.0;
};

}  // namespace foothold::hyrecro
