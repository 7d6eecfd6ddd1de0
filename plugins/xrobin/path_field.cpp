// Dijkstra from the goal over cells in which body A has room.
#include "path_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace foothold::xrobin {
namespace {

using geometry::Vector2d;

constexpr double kMargin = 0.4;  // m round everything: ways round the outermost obstacles
constexpr double kMostCells = 250000.0;
constexpr std::size_t kLookEvery = 1024;  // cells between two looks at the stop token
constexpr float kInfinity = std::numeric_limits<float>::infinity();

}  // namespace

PathField::PathField(const Surroundings& surroundings, const Vector2d& start, const Vector2d& goal, const std::stop_token& stop)
    : goal_(goal) {
  Vector2d low = start.cwiseMin(goal);
  Vector2d high = start.cwiseMax(goal);
  for (const geometry::Obstacle& obstacle : surroundings.obstacles())
    for (const Vector2d& v : obstacle.polygon) low = low.cwiseMin(v), high = high.cwiseMax(v);
  low.array() -= kMargin;
  high.array() += kMargin;
  const Vector2d extent = high - low;
  cell_ = std::max(cell_, std::sqrt(extent.x() * extent.y() / kMostCells));
  corner_ = low;
  columns_ = static_cast<int>(extent.x() / cell_) + 1;
  rows_ = static_cast<int>(extent.y() / cell_) + 1;
  const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  const auto centre = [&](std::size_t k) {
    return Vector2d(corner_.x() + (static_cast<double>(k % static_cast<std::size_t>(columns_)) + 0.5) * cell_,
                    corner_.y() + (static_cast<double>(k / static_cast<std::size_t>(columns_)) + 0.5) * cell_);
  };
  std::vector<char> room(cells);
  for (std::size_t k = 0; k < cells; ++k) {
    if (k % kLookEvery == 0 && stop.stop_requested()) return;
    room[k] = surroundings.room_for_a(centre(k).x(), centre(k).y()) ? 1 : 0;
  }

  // From the cells with room that are nearest to the goal: from its own one if it has room.
  distance_.assign(cells, kInfinity);
  using Entry = std::pair<float, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < cells; ++k)
    if (room[k]) least = std::min(least, (centre(k) - goal).norm());
  for (std::size_t k = 0; k < cells; ++k) {
    const double away = (centre(k) - goal).norm();
    if (room[k] && away <= least + cell_) distance_[k] = static_cast<float>(away), open.emplace(distance_[k], k);
  }
  for (std::size_t looks = 0; !open.empty(); ++looks) {
    if (looks % kLookEvery == 0 && stop.stop_requested()) return;
    const auto [length, k] = open.top();
    open.pop();
    if (length > distance_[k]) continue;
    const int row = static_cast<int>(k) / columns_;
    const int column = static_cast<int>(k) % columns_;
    for (int dr = -1; dr <= 1; ++dr)
      for (int dc = -1; dc <= 1; ++dc) {
        const int r = row + dr;
        const int c = column + dc;
        if ((dr == 0 && dc == 0) || r < 0 || c < 0 || r >= rows_ || c >= columns_) continue;
        const auto to = static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
        const float next = length + static_cast<float>(cell_ * (dr != 0 && dc != 0 ? std::numbers::sqrt2 : 1.0));
        if (!room[to] || next >= distance_[to]) continue;
        distance_[to] = next;
        open.emplace(next, to);
      }
  }
}

double PathField::distance(double x, double y) const {
  const double column = std::clamp((x - corner_.x()) / cell_, 0.0, columns_ - 1.0);
  const double row = std::clamp((y - corner_.y()) / cell_, 0.0, rows_ - 1.0);
  const double beside = std::hypot(x - (corner_.x() + std::clamp(x - corner_.x(), 0.0, columns_ * cell_)),
                                   y - (corner_.y() + std::clamp(y - corner_.y(), 0.0, rows_ * cell_)));
  // The cell's own centre may lack room where the place has it: any neighbour will do.
  float least = kInfinity;
  for (int dr = -1; dr <= 1; ++dr)
    for (int dc = -1; dc <= 1; ++dc) {
      const int r = static_cast<int>(row) + dr;
      const int c = static_cast<int>(column) + dc;
      if (r < 0 || c < 0 || r >= rows_ || c >= columns_) continue;
      const float step = static_cast<float>(cell_ * std::hypot(dr, dc));
      least = std::min(
          least, distance_[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c)] + step);
    }
  return beside + static_cast<double>(least);
}

}  // namespace foothold::xrobin
