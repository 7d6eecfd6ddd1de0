// The k-d tree over ground triangles' centroids that Molla-Santamaria et al. 2023 (sections 3 and 5) search in: neighbours of
// nodes, and candidates for a foot's triangle.
//
// A centroid within the radius is no proof that its triangle is the nearest one (a large triangle's centroid may be far away):
// Surface::nearest() is exact. Immutable; any thread.
#pragma once

#include <memory>
#include <vector>

#include "terrain/surface.hpp"

namespace foothold::terrain {

class CentroidTree {
 public:
  // Borrows the terrain, which must outlive it.
  explicit CentroidTree(const Terrain& terrain);
  CentroidTree(CentroidTree&&) noexcept;
  CentroidTree& operator=(CentroidTree&&) noexcept;
  ~CentroidTree();

  // The ground triangles with the `count` centroids nearest to `p`, nearest first (equally near: the lower index first); fewer if
  // there are no more.
  std::vector<int> nearest(const Vector3d& p, std::size_t count) const;
  // Those whose centroids are nearer than `radius` (m), in the same order.
  std::vector<int> within(const Vector3d& p, double radius) const;

  // The paper's foothold: of the triangles whose centroids are nearer to the shoulder than `radius` (paper: 1.5 R, R the stretched
  // leg), the one nearest to the foot, and the foot's nearest point on it. triangle -1: no centroid within the radius.
  Nearest foothold(const Vector3d& foot, const Vector3d& shoulder, double radius) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace foothold::terrain
