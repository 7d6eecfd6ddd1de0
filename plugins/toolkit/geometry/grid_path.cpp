// Grid points by their two indices; euclidean distance as heuristic, which is consistent on a grid.
#include "geometry/grid_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>
#include <unordered_map>

namespace foothold::geometry {
namespace {

struct Open {
  double estimate;
  double cost;
  std::int32_t i, j;
  bool operator<(const Open& other) const { return estimate > other.estimate; }
};

struct Reached {
  double cost;
  std::uint64_t before;
  bool closed;
};

std::uint64_t key(std::int32_t i, std::int32_t j) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32) | static_cast<std::uint32_t>(j);
}

}  // namespace

std::vector<Vector2d> grid_path(const PolygonPaths& inside, const Vector2d& from, const Vector2d& to, double step,
                                GridNeighbours neighbours) {
  if (!inside.holds(from) || !inside.holds(to)) return {};
  const auto place = [&](std::int32_t i, std::int32_t j) { return Vector2d(from + step * Vector2d(i, j)); };
  std::unordered_map<std::uint64_t, Reached> reached;
  std::priority_queue<Open> open;
  reached[key(0, 0)] = {0.0, key(0, 0), false};
  open.push({(to - from).norm(), 0.0, 0, 0});
  double best = std::numeric_limits<double>::infinity();
  std::uint64_t last = 0;
  while (!open.empty() && open.top().estimate < best) {
    const Open at = open.top();
    open.pop();
    Reached& here = reached[key(at.i, at.j)];
    if (here.closed) continue;
    here.closed = true;
    const Vector2d point = place(at.i, at.j);
    const Vector2d left = (to - point).cwiseAbs();
    if (left.maxCoeff() < step && at.cost + left.norm() < best && inside.sees(point, to)) {
      best = at.cost + left.norm();
      last = key(at.i, at.j);
    }
    for (std::int32_t di = -1; di <= 1; ++di)
      for (std::int32_t dj = -1; dj <= 1; ++dj) {
        if ((di == 0 && dj == 0) || (neighbours == GridNeighbours::kFour && di != 0 && dj != 0)) continue;
        const std::int32_t i = at.i + di, j = at.j + dj;
        const Vector2d next = place(i, j);
        const double cost = at.cost + step * std::sqrt(static_cast<double>(di * di + dj * dj));
        const auto known = reached.find(key(i, j));
        if (known != reached.end() && (known->second.closed || known->second.cost <= cost)) continue;
        if (!inside.sees(point, next)) continue;
        reached[key(i, j)] = {cost, key(at.i, at.j), false};
        open.push({cost + (to - next).norm(), cost, i, j});
      }
  }
  if (!std::isfinite(best)) return {};
  std::vector<Vector2d> out{to};
  for (std::uint64_t at = last;; at = reached[at].before) {
    const Vector2d point = place(static_cast<std::int32_t>(at >> 32), static_cast<std::int32_t>(at & 0xffffffffU));
    if ((point - to).norm() > kOnBoundary) out.push_back(point);
    if (at == key(0, 0)) break;
  }
  std::reverse(out.begin(), out.end());
  return out;
}

double length_of(const std::vector<Vector2d>& path) {
  double sum = 0.0;
  for (std::size_t k = 1; k < path.size(); ++k) sum += (path[k] - path[k - 1]).norm();
  return sum;
}

}  // namespace foothold::geometry
