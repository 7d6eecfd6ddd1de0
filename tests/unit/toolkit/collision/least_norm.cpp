// Every difference of two corners is looked at, every face of the simplex is solved: slow, and nothing to get wrong.
#include "least_norm.hpp"

#include <algorithm>
#include <limits>

namespace foothold::collision {
namespace {

// The point of least norm in the hull of at most four points, and which of them it needs.
std::pair<Vector3d, Points> nearest_in(const Points& simplex) {
  Vector3d best = simplex.front();
  Points needed{best};
  double least = std::numeric_limits<double>::infinity();
  for (unsigned subset = 1; subset < 1u << simplex.size(); ++subset) {
    Points chosen;
    for (std::size_t k = 0; k < simplex.size(); ++k)
      if ((subset >> k & 1u) != 0) chosen.push_back(simplex[k]);
    const auto edges = static_cast<Eigen::Index>(chosen.size()) - 1;
    Eigen::VectorXd weights(edges);
    if (edges > 0) {
      Eigen::MatrixXd matrix(3, edges);
      for (Eigen::Index k = 0; k < edges; ++k) matrix.col(k) = chosen[static_cast<std::size_t>(k) + 1] - chosen[0];
      weights = matrix.colPivHouseholderQr().solve(-chosen[0]);
      if (weights.minCoeff() < 0.0 || weights.sum() > 1.0) continue;
    }
    Vector3d point = chosen[0];
    for (Eigen::Index k = 0; k < edges; ++k) point += weights[k] * (chosen[static_cast<std::size_t>(k) + 1] - chosen[0]);
    if (point.squaredNorm() < least) least = point.squaredNorm(), best = point, needed = chosen;
  }
  return {best, needed};
}

}  // namespace

Points points_of(const Capsule& capsule) { return {capsule.a, capsule.b}; }
Points points_of(const Patch& patch) { return {patch.vertices.begin(), patch.vertices.end()}; }

Points points_of(const Box& box) {
  Points out;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) out.push_back(box.pose * box.half.cwiseProduct(Vector3d(x, y, z)));
  return out;
}

Bracket hull_distance(const Points& a, const Points& b) {
  Points simplex{a.front() - b.front()};
  Bracket out{0.0, std::numeric_limits<double>::infinity()};
  for (int round = 0; round < 100; ++round) {
    const auto [point, needed] = nearest_in(simplex);
    const double norm = point.norm();
    if (norm >= out.high) break;
    out.high = norm;
    if (norm < 1e-13) break;
    const auto lower = [&](const Vector3d& p, const Vector3d& q) { return p.dot(point) < q.dot(point); };
    const Vector3d support = *std::min_element(a.begin(), a.end(), lower) - *std::max_element(b.begin(), b.end(), lower);
    out.low = std::max(out.low, support.dot(point) / norm);
    if (out.high - out.low < 1e-13 || needed.size() == 4) break;
    simplex = needed;
    simplex.push_back(support);
  }
  return out;
}

}  // namespace foothold::collision
