// Sorting points into clusters and clusters into cells.
#include "pair_index.hpp"

#include <algorithm>
#include <numeric>

namespace foothold::xrobin {
namespace {

// For a robot with a travel of 50 mm in its slot; m.
constexpr double kClusterSize = 1e-4;                                                          // side of the square of a cluster
constexpr std::uint32_t kPerCell = 8;                                                          // squares along the side of a cell
constexpr std::array<double, PairIndex::kScales> kNear{5e-5, 1e-4, 2e-4, 4e-4, 8e-4, 3.2e-3};  // radii of the maps

struct Point {
  float x, y;
  std::uint32_t id;
  std::uint32_t key;  // points of the same cluster have the same one; sorting by it gives the order of the clusters
};

// Stable: points of equal keys keep their order. Keys below 2^32.
void sort_by_key(std::vector<Point>& points) {
  constexpr int kBits = 11;
  constexpr std::size_t kBuckets = std::size_t{1} << kBits;
  std::vector<Point> other(points.size());
  for (int shift = 0; shift < 32; shift += kBits) {
    std::array<std::size_t, kBuckets + 1> at{};
    for (const Point& point : points) ++at[(point.key >> shift & (kBuckets - 1)) + 1];
    std::partial_sum(at.begin(), at.end(), at.begin());
    for (const Point& point : points) other[at[point.key >> shift & (kBuckets - 1)]++] = point;
    points.swap(other);
  }
}

// Stable counting sort by heading.
std::vector<Point> by_turn(const std::vector<Point>& points, const std::vector<std::uint16_t>& turn, std::size_t turns) {
  std::vector<std::size_t> at(turns + 1, 0);
  for (const std::uint16_t t : turn) ++at[t + 1u];
  std::partial_sum(at.begin(), at.end(), at.begin());
  std::vector<Point> out(points.size());
  for (const Point& point : points) out[at[turn[point.id]]++] = point;
  return out;
}

// Appends the clusters of sorted points, and the end mark. Calls began(point) with the first point of each cluster. `part` tells
// points apart that must not share a cluster.
template <class Part, class Began>
void gather(const std::vector<Point>& points, Points& out, std::vector<Cluster>& clusters, Part part, Began began) {
  out.x.reserve(points.size()), out.y.reserve(points.size()), out.id.reserve(points.size());
  for (std::size_t from = 0; from < points.size();) {
    const Point& first = points[from];
    float left = first.x, right = left, bottom = first.y, top = bottom;
    std::size_t to = from;
    for (; to < points.size() && points[to].key == first.key && part(points[to]) == part(first); ++to) {
      left = std::min(left, points[to].x), right = std::max(right, points[to].x);
      bottom = std::min(bottom, points[to].y), top = std::max(top, points[to].y);
      out.x.push_back(points[to].x), out.y.push_back(points[to].y), out.id.push_back(points[to].id);
    }
    clusters.push_back({0.5F * (left + right), 0.5F * (bottom + top), 0.5F * std::hypot(right - left, top - bottom),
                        static_cast<std::uint32_t>(from)});
    began(first);
    from = to;
  }
  clusters.push_back({0.0F, 0.0F, 0.0F, static_cast<std::uint32_t>(points.size())});
}

}  // namespace

PairIndex::PairIndex(const PoseLevel& level, const Turns& turns, double travel) {
  const std::size_t size = level.size();
  const double scale = travel / 0.05;
  for (std::size_t k = 0; k < size; ++k) reach = std::max(reach, std::hypot(level.x[k], level.y[k]));
  cells.size = scale * kClusterSize * kPerCell;
  cells.columns = 2 * (static_cast<int>(reach / cells.size) + 2);
  const Cells squares{scale * kClusterSize, cells.columns * static_cast<int>(kPerCell)};

  std::vector<Point> points(size);
  for (std::size_t k = 0; k < size; ++k) {
    const double c = turns.cosine(level.turn[k]);
    const double s = turns.sine(level.turn[k]);
    const auto x = static_cast<float>(-c * level.x[k] - s * level.y[k]);
    const auto y = static_cast<float>(s * level.x[k] - c * level.y[k]);
    // Cell by cell, and square by square inside a cell.
    const std::uint32_t column = squares.of(x), row = squares.of(y);
    const std::uint32_t cell = row / kPerCell * static_cast<std::uint32_t>(cells.columns) + column / kPerCell;
    points[k] = {x, y, static_cast<std::uint32_t>(k), (cell * kPerCell + row % kPerCell) * kPerCell + column % kPerCell};
  }
  sort_by_key(points);
  cell_clusters.assign(static_cast<std::size_t>(cells.columns) * static_cast<std::size_t>(cells.columns) + 1, 0);
  gather(
      points, suffixes, suffix_clusters, [](const Point&) { return 0; },
      [&](const Point& first) { ++cell_clusters[first.key / (kPerCell * kPerCell) + 1]; });
  std::partial_sum(cell_clusters.begin(), cell_clusters.end(), cell_clusters.begin());
  suffix_tree = BoxTree({suffix_clusters.data(), suffix_clusters.size() - 1});

  points = by_turn(points, level.turn, turns.size());
  turn_clusters.assign(turns.size() + 1, 0);
  gather(
      points, prefixes, prefix_clusters, [&](const Point& point) { return level.turn[point.id]; },
      [&](const Point& first) { ++turn_clusters[level.turn[first.id] + 1u]; });
  std::partial_sum(turn_clusters.begin(), turn_clusters.end(), turn_clusters.begin());
  for (const Cluster& cluster : prefix_clusters) {
    widest_prefix_cluster = std::max(widest_prefix_cluster, cluster.spread);
    prefix_x.push_back(cluster.x), prefix_y.push_back(cluster.y);
  }

  for (std::size_t k = 0; k < near.size(); ++k) near[k] = near_map(suffixes.x, suffixes.y, reach, scale * kNear[k], kMargin);
}

}  // namespace foothold::xrobin
