// Dijkstra over corners; what sees what is asked of the edges.
#include "geometry/geodesic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foothold::geometry {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTouch = 1e-9;  // m: a segment that enters an obstacle by less only touches it

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// Whether the segment passes through the polygon's inside, deeper than kTouch: its crossings with the edges part it, and the middle
// of some part lies inside.
bool enters(const Polygon& polygon, const Vector2d& from, const Vector2d& to) {
  const Vector2d along = to - from;
  const double length = along.norm();
  if (length == 0.0) return false;
  std::vector<double> cuts{0.0, 1.0};
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2d& a = polygon[k];
    const Vector2d edge = polygon[(k + 1) % polygon.size()] - a;
    const double turn = cross(along, edge);
    if (turn == 0.0) {
      // Parallel: where the edge lies on the segment its ends part it.
      for (const Vector2d& end : {a, Vector2d(a + edge)}) cuts.push_back((end - from).dot(along) / (length * length));
      continue;
    }
    const double on_segment = cross(a - from, edge) / turn;
    const double on_edge = cross(a - from, along) / turn;
    if (on_edge >= -kTouch && on_edge <= 1.0 + kTouch) cuts.push_back(on_segment);
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t k = 1; k < cuts.size(); ++k) {
    const double low = std::clamp(cuts[k - 1], 0.0, 1.0);
    const double high = std::clamp(cuts[k], 0.0, 1.0);
    if ((high - low) * length < kTouch) continue;
    const Vector2d middle = from + 0.5 * (low + high) * along;
    if (!contains(polygon, middle)) continue;
    double depth = kInfinity;
    for (std::size_t i = 0; i < polygon.size(); ++i)
      depth = std::min(depth, distance(middle, polygon[i], polygon[(i + 1) % polygon.size()]));
    if (depth > kTouch) return true;
  }
  return false;
}

}  // namespace

Geodesic::Geodesic(const Vector2d& goal, const std::vector<Polygon>& obstacles, const std::stop_token& stop)
    : goal_(goal), obstacles_(obstacles) {
  for (const Polygon& polygon : obstacles_) circles_.push_back(circle_round(polygon));
  std::vector<Corner> open;
  for (const Polygon& polygon : obstacles_)
    for (const Vector2d& corner : polygon) open.push_back({corner, sees(corner, goal) ? (corner - goal).norm() : kInfinity});
  while (!open.empty() && !stop.stop_requested()) {
    const auto nearest =
        std::min_element(open.begin(), open.end(), [](const Corner& a, const Corner& b) { return a.distance < b.distance; });
    if (!std::isfinite(nearest->distance)) break;
    const Corner corner = *nearest;
    open.erase(nearest);
    for (Corner& other : open) {
      const double through = corner.distance + (other.at - corner.at).norm();
      if (through < other.distance && sees(other.at, corner.at)) other.distance = through;
    }
    corners_.push_back(corner);
  }
}

bool Geodesic::sees(const Vector2d& from, const Vector2d& to) const {
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    if (geometry::distance(circles_[k].centre, from, to) > circles_[k].radius) continue;
    if (enters(obstacles_[k], from, to)) return false;
  }
  return true;
}

double Geodesic::distance(const Vector2d& point) const {
  if (sees(point, goal_)) return (point - goal_).norm();
  double least = kInfinity;
  for (const Corner& corner : corners_) {
    if (corner.distance >= least) break;
    const double through = corner.distance + (point - corner.at).norm();
    if (through < least && sees(point, corner.at)) least = through;
  }
  return least;
}

}  // namespace foothold::geometry
