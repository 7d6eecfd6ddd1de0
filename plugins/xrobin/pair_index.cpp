// Sorting points into clusters and clusters into cells.
#include "pair_index.hpp"

#include <algorithm>
#include <numeric>

namespace foothold::xrobin {
namespace {

constexpr double kClusterSize = 1e-4;                                              // m, side of the square of a cluster
constexpr double kCellSize = 8e-4;                                                 // m, a whole number of cluster squares
constexpr std::array<double, PairIndex::kScales> kNear{1e-4, 2e-4, 8e-4, 3.2e-3};  // m; the maps' cells are twice as wide

struct Point {
  float x, y;
  std::uint32_t id;
  std::uint64_t key;  // points of the same cluster have the same one; sorting by it gives the order of the clusters
};

void sort_by_key(std::vector<Point>& points) {
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.key != b.key ? a.key < b.key : a.id < b.id; });
}

// Appends the clusters of sorted points, and the end mark.
void gather(const std::vector<Point>& points, Points& out, std::vector<Cluster>& clusters, std::vector<std::uint64_t>& keys) {
  for (std::size_t from = 0; from < points.size();) {
    std::size_t to = from;
    float left = points[from].x, right = left, bottom = points[from].y, top = bottom;
    for (; to < points.size() && points[to].key == points[from].key; ++to) {
      left = std::min(left, points[to].x), right = std::max(right, points[to].x);
      bottom = std::min(bottom, points[to].y), top = std::max(top, points[to].y);
      out.x.push_back(points[to].x), out.y.push_back(points[to].y), out.id.push_back(points[to].id);
    }
    clusters.push_back({0.5F * (left + right), 0.5F * (bottom + top), 0.5F * std::hypot(right - left, top - bottom),
                        static_cast<std::uint32_t>(from)});
    keys.push_back(points[from].key);
    from = to;
  }
  clusters.push_back({0.0F, 0.0F, 0.0F, static_cast<std::uint32_t>(points.size())});
}

NearMap near_map(const Points& points, double reach, double radius) {
  const double cell = 2.0 * radius;
  NearMap map;
  const int half = static_cast<int>((reach + radius) / cell) + 2;
  map.radius = static_cast<float>(radius);
  map.per_metre = static_cast<float>(1.0 / cell);
  map.offset = static_cast<float>(half);
  map.columns = static_cast<std::uint32_t>(2 * half);
  map.bits.assign((static_cast<std::size_t>(map.columns) * map.columns + 31) / 32, 0);
  // A hair more than the radius, so that rounding a place to a cell cannot miss a point.
  const float hair = static_cast<float>(radius) + PairIndex::kMargin;
  for (std::size_t k = 0; k < points.x.size(); ++k) {
    const auto cell_of = [&](float v) { return static_cast<std::uint32_t>(v * map.per_metre + map.offset); };
    for (std::uint32_t row = cell_of(points.y[k] - hair); row <= cell_of(points.y[k] + hair); ++row)
      for (std::uint32_t column = cell_of(points.x[k] - hair); column <= cell_of(points.x[k] + hair); ++column) {
        const std::uint32_t bit = row * map.columns + column;
        map.bits[bit / 32] |= 1u << (bit % 32);
      }
  }
  return map;
}

}  // namespace

PairIndex::PairIndex(const PoseLevel& level, const Turns& turns) {
  const std::size_t size = level.size();
  for (std::size_t k = 0; k < size; ++k) reach = std::max(reach, std::hypot(level.x[k], level.y[k]));
  cells.size = kCellSize;
  cells.columns = 2 * (static_cast<int>(reach / kCellSize) + 2);
  const Cells squares{kClusterSize, cells.columns * static_cast<int>(kCellSize / kClusterSize + 0.5)};
  const std::uint32_t per_cell = static_cast<std::uint32_t>(squares.columns / cells.columns);

  std::vector<Point> points(size);
  std::vector<std::uint64_t> suffix_keys, prefix_keys;
  for (std::size_t k = 0; k < size; ++k) {
    const double c = turns.cosine(level.turn[k]);
    const double s = turns.sine(level.turn[k]);
    const auto x = static_cast<float>(-c * level.x[k] - s * level.y[k]);
    const auto y = static_cast<float>(s * level.x[k] - c * level.y[k]);
    // Cell by cell, and square by square inside a cell.
    const std::uint32_t column = squares.of(x), row = squares.of(y);
    const std::uint64_t cell = (row / per_cell) * static_cast<std::uint64_t>(cells.columns) + column / per_cell;
    points[k] = {x, y, static_cast<std::uint32_t>(k), (cell * per_cell + row % per_cell) * per_cell + column % per_cell};
  }
  sort_by_key(points);
  gather(points, suffixes, suffix_clusters, suffix_keys);
  suffix_tree = BoxTree({suffix_clusters.data(), suffix_clusters.size() - 1});
  cell_clusters.assign(static_cast<std::size_t>(cells.columns) * static_cast<std::size_t>(cells.columns) + 1, 0);
  for (const std::uint64_t key : suffix_keys) ++cell_clusters[key / (per_cell * per_cell) + 1];
  std::partial_sum(cell_clusters.begin(), cell_clusters.end(), cell_clusters.begin());

  for (Point& point : points) point.key |= static_cast<std::uint64_t>(level.turn[point.id]) << 40;
  sort_by_key(points);
  gather(points, prefixes, prefix_clusters, prefix_keys);
  turn_clusters.assign(turns.size() + 1, 0);
  for (const std::uint64_t key : prefix_keys) ++turn_clusters[(key >> 40) + 1];
  std::partial_sum(turn_clusters.begin(), turn_clusters.end(), turn_clusters.begin());
  for (const Cluster& cluster : prefix_clusters) widest_prefix_cluster = std::max(widest_prefix_cluster, cluster.spread);

  for (std::size_t k = 0; k < near.size(); ++k) near[k] = near_map(suffixes, reach, kNear[k]);
}

}  // namespace foothold::xrobin
