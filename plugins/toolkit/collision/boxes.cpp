// Box against box: separating axes for the quick answer, corners and edges for the distance.
#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/segments.hpp"

namespace foothold::collision {
namespace {

// Box a seen from box b.
struct Relative {
  Eigen::Matrix3d rotation;  // columns: a's axes
  Vector3d centre, half_a, half_b;
};

Relative relative(const Box& a, const Box& b) {
  const auto from_world = b.pose.linear().transpose();
  return {from_world * a.pose.linear(), from_world * Vector3d(a.pose.translation() - b.pose.translation()), a.half, b.half};
}

// The greatest gap along one of the 15 axes (negative: no axis separates them), never more than the distance of disjoint boxes.
// Ends early with any gap of at least `enough`. (Gottschalk, Lin, Manocha: OBBTree, 1996; here with normalised axes.)
double greatest_gap(const Relative& r, double enough) {
  const Eigen::Matrix3d size = r.rotation.cwiseAbs();
  double best = (r.centre.cwiseAbs() - r.half_b - size * r.half_a).maxCoeff();
  if (best >= enough) return best;
  const Vector3d centre_a = r.rotation.transpose() * r.centre;
  best = std::max(best, (centre_a.cwiseAbs() - r.half_a - size.transpose() * r.half_b).maxCoeff());
  if (best >= enough) return best;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Index i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (Eigen::Index j = 0; j < 3; ++j) {
      const Eigen::Index j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      // e_i x (column j) has the components -R(i2, j) along i1 and R(i1, j) along i2.
      const double length_squared = r.rotation(i1, j) * r.rotation(i1, j) + r.rotation(i2, j) * r.rotation(i2, j);
      if (length_squared < 1e-20) continue;  // parallel edges: the faces' axes tell the same
      const double gap = std::fabs(r.centre[i2] * r.rotation(i1, j) - r.centre[i1] * r.rotation(i2, j)) -
                         r.half_b[i1] * size(i2, j) - r.half_b[i2] * size(i1, j) - r.half_a[j1] * size(i, j2) -
                         r.half_a[j2] * size(i, j1);
      best = std::max(best, gap / std::sqrt(length_squared));
    }
    if (best >= enough) return best;
  }
  return best;
}

using Corners = std::array<Vector3d, 8>;

double squared_of_corners(const Corners& corners, const Vector3d& half) {
  double best = std::numeric_limits<double>::infinity();
  for (const Vector3d& corner : corners) best = std::min(best, squared_to_box(corner, half));
  return best;
}

// The least of `best` and the edges' distances.
double squared_of_edges(const Corners& corners, const Vector3d& half, double best) {
  for (const auto& [from, to] : kEdges)
    if (squared_bound(corners[from], corners[to], half) < best)
      best = std::min(best, squared_to_box(corners[from], corners[to], half));
  return best;
}

Corners corners_of_a(const Relative& r) {
  return corners_of(r.centre, r.half_a.x() * r.rotation.col(0), r.half_a.y() * r.rotation.col(1), r.half_a.z() * r.rotation.col(2));
}

Corners corners_of_b(const Relative& r) {
  const Eigen::Matrix3d inverse = r.rotation.transpose();
  return corners_of(-(inverse * r.centre), r.half_b.x() * inverse.col(0), r.half_b.y() * inverse.col(1),
                    r.half_b.z() * inverse.col(2));
}

constexpr double kDeep = 1e-7;      // m: the axes of nearly parallel edges may miss a gap of so much
constexpr double kReached = 1e-11;  // m: so near to a proved lower bound no further feature counts

// Nearest points of disjoint boxes: a corner and a point of the other box, or two edges. `gap` as greatest_gap() gives it. A result
// below `enough` need not be the least.
double squared_of_features(const Relative& r, double gap, double enough) {
  const double floor = std::max(0.0, gap) + kReached;
  const double done = std::max(floor * floor, enough);
  const Corners a = corners_of_a(r);
  double best = squared_of_corners(a, r.half_b);
  if (best <= done) return best;
  const Corners b = corners_of_b(r);
  best = std::min(best, squared_of_corners(b, r.half_a));
  if (best <= done) return best;
  best = squared_of_edges(a, r.half_b, best);
  // Where no axis separates them, an edge of b may stand in a face of a.
  return gap > 0.0 ? best : squared_of_edges(b, r.half_a, best);
}

}  // namespace

double distance(const Box& a, const Box& b) {
  const Relative r = relative(a, b);
  const double gap = greatest_gap(r, std::numeric_limits<double>::infinity());
  return gap < -kDeep ? 0.0 : std::sqrt(squared_of_features(r, gap, 0.0));
}

bool nearer(const Box& a, const Box& b, double clearance) {
  const Relative r = relative(a, b);
  const double gap = greatest_gap(r, clearance);
  if (gap >= clearance) return false;
  if (gap < -kDeep || clearance <= 0.0) return true;
  const double limit = clearance * clearance;
  return squared_of_features(r, gap, std::nextafter(limit, 0.0)) < limit;
}

}  // namespace foothold::collision
