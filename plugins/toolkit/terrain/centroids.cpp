// nanoflann, kept in here.
#include "terrain/centroids.hpp"

#include <algorithm>
#include <nanoflann.hpp>

namespace foothold::terrain {
namespace {

struct Points {
  std::vector<int> triangles;
  std::vector<Vector3d> at;
  std::size_t kdtree_get_point_count() const { return at.size(); }
  double kdtree_get_pt(std::size_t k, std::size_t axis) const { return at[k][static_cast<Eigen::Index>(axis)]; }
  template <class Bounds>
  bool kdtree_get_bbox(Bounds&) const {
    return false;
  }
};

using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>, Points, 3, std::uint32_t>;
using Found = std::vector<std::pair<std::uint32_t, double>>;  // index, squared distance

Points points_of(const Terrain& terrain) {
  Points out;
  for (std::size_t t = 0; t < terrain.size(); ++t)
    if (terrain.ground[t] != 0) {
      out.triangles.push_back(static_cast<int>(t));
      out.at.push_back(terrain.centroids[t]);
    }
  return out;
}

}  // namespace

struct CentroidTree::Tree {
  explicit Tree(const Terrain& of) : terrain(&of), points(points_of(of)), index(3, points) {}

  Found within(const Vector3d& p, double squared) const {
    Found found;
    index.radiusSearch(p.data(), squared, found, nanoflann::SearchParams(0, 0.0F, false));
    return found;
  }
  std::vector<int> in_order(Found found) const {
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.second != b.second ? a.second < b.second : a.first < b.first; });
    std::vector<int> out;
    for (const auto& [k, distance] : found) out.push_back(points.triangles[k]);
    return out;
  }

  const Terrain* terrain;
  Points points;
  Index index;
};

CentroidTree::CentroidTree(const Terrain& terrain) : tree_(std::make_unique<Tree>(terrain)) {}
CentroidTree::CentroidTree(CentroidTree&&) noexcept = default;
CentroidTree& CentroidTree::operator=(CentroidTree&&) noexcept = default;
CentroidTree::~CentroidTree() = default;

std::vector<int> CentroidTree::nearest(const Vector3d& p, std::size_t count) const {
  count = std::min(count, tree_->points.at.size());
  if (count == 0) return {};
  std::vector<std::uint32_t> which(count);
  std::vector<double> squared(count);
  tree_->index.knnSearch(p.data(), count, which.data(), squared.data());
  // Which of several equally far ones came in last depends on the tree: the order is made ours.
  std::vector<int> out = tree_->in_order(tree_->within(p, std::nextafter(squared.back(), INFINITY)));
  out.resize(count);
  return out;
}

std::vector<int> CentroidTree::within(const Vector3d& p, double radius) const {
  return tree_->in_order(tree_->within(p, radius * radius));
}

Nearest CentroidTree::foothold(const Vector3d& foot, const Vector3d& shoulder, double radius) const {
  Nearest best;
  for (const auto& [k, squared] : tree_->within(shoulder, radius * radius)) {
    const int t = tree_->points.triangles[k];
    const Terrain& terrain = *tree_->terrain;
    const Vector3d point = nearest_on_triangle(foot, terrain.corner(t, 0), terrain.corner(t, 1), terrain.corner(t, 2));
    const double distance = (point - foot).norm();
    if (distance < best.distance || (distance == best.distance && t < best.triangle)) best = {t, point, distance};
  }
  return best;
}

}  // namespace foothold::terrain
