// The fifteen directions of separating axes (Gottschalk, Lin, Manocha: OBBTree, 1996), of either instant.
#include "bioloid/posture/planes.hpp"

#include <utility>

namespace foothold::bioloid {

using collision::Box;
using Eigen::Vector3d;

bool parted(const Box& a0, const Box& b0, const Box& a1, const Box& b1, double needed) {
  const auto gap = [](const Box& a, const Box& b, const Vector3d& n) { return least_along(b, n) + least_along(a, -n); };
  const auto along = [&](const Vector3d& n, const Box& a, const Box& b) {
    const Vector3d towards = n.dot(b.pose.translation() - a.pose.translation()) >= 0.0 ? n : Vector3d(-n);
    return gap(a0, b0, towards) >= needed && gap(a1, b1, towards) >= needed;
  };
  for (const auto& [a, b] : {std::pair(&a0, &b0), std::pair(&a1, &b1)}) {
    for (int i = 0; i < 3; ++i)
      if (along(a->pose.linear().col(i), *a, *b) || along(b->pose.linear().col(i), *a, *b)) return true;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const Vector3d n = a->pose.linear().col(i).cross(b->pose.linear().col(j));
        if (n.squaredNorm() > 1e-8 && along(n.normalized(), *a, *b)) return true;
      }
  }
  return false;
}

}  // namespace foothold::bioloid
