// nanoflann answers the first so many; each time they do not suffice, four times as many are asked for.
#include "hyrecro/paper/workspace_order.hpp"

#include <algorithm>
#include <limits>
#include <nanoflann.hpp>

namespace foothold::hyrecro {
namespace {

struct Places {
  std::vector<Eigen::Vector2d> at;
  std::size_t kdtree_get_point_count() const { return at.size(); }
  double kdtree_get_pt(std::size_t index, std::size_t axis) const { return at[index][static_cast<Eigen::Index>(axis)]; }
  template <class Bounds>
  bool kdtree_get_bbox(Bounds&) const {
    return false;
  }
};

}  // namespace

struct WorkspaceOrder::Tree {
  explicit Tree(Places of) : places(std::move(of)) {}
  Places places;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Places>, Places, 2, std::size_t> index{2, places};
};

WorkspaceOrder::WorkspaceOrder(std::shared_ptr<const PlanarWorkspace> workspace) : workspace_(std::move(workspace)) {
  Places places;
  least_reach_ = std::numeric_limits<double>::infinity();
  for (const PlanarWorkspace::Cell& cell : workspace_->cells()) {
    places.at.push_back(position(cell));
    least_reach_ = std::min(least_reach_, places.at.back().norm());
  }
  tree_ = std::make_unique<const Tree>(std::move(places));
}

WorkspaceOrder::~WorkspaceOrder() = default;

Eigen::Vector2d WorkspaceOrder::position(const PlanarWorkspace::Cell& cell) const {
  return workspace_->position_step() * Eigen::Vector2d(cell.i, cell.j);
}

bool WorkspaceOrder::nearest_first(const Eigen::Vector2d& point,
                                   const std::function<bool(const PlanarWorkspace::Cell&)>& take) const {
  const std::vector<PlanarWorkspace::Cell>& cells = workspace_->cells();
  std::vector<std::size_t> indices;
  std::vector<double> squares;
  std::size_t taken = 0;
  for (std::size_t wanted = 32; taken < cells.size(); wanted *= 4) {
    wanted = std::min(wanted, cells.size());
    indices.resize(wanted);
    squares.resize(wanted);
    const std::size_t found = tree_->index.knnSearch(point.data(), wanted, indices.data(), squares.data());
    for (; taken < found; ++taken)
      if (take(cells[indices[taken]])) return true;
  }
  return false;
}

}  // namespace foothold::hyrecro
