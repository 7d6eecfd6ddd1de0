// A uniform grid with about as many cells as things.
#include "screen_grid.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::drawing {

ScreenGrid::ScreenGrid(const Box2& bounds, std::size_t expected)
    : low_(bounds.low), side_(std::clamp<std::size_t>(static_cast<std::size_t>(std::sqrt(static_cast<double>(expected))), 1, 256)) {
  cell_ = ((bounds.high - bounds.low) / static_cast<double>(side_)).cwiseMax(1e-9);
  cells_.resize(side_ * side_);
}

ScreenGrid::Cells ScreenGrid::cells_of(const Box2& box) const {
  const auto cell = [&](double at, int axis) {
    return static_cast<std::size_t>(std::clamp((at - low_[axis]) / cell_[axis], 0.0, static_cast<double>(side_ - 1)));
  };
  return {cell(box.low.x(), 0), cell(box.low.y(), 1), cell(box.high.x(), 0), cell(box.high.y(), 1)};
}

void ScreenGrid::insert(std::size_t thing, const Box2& box) {
  if (boxes_.size() <= thing) boxes_.resize(thing + 1);
  boxes_[thing] = box;
  const Cells at = cells_of(box);
  for (std::size_t y = at.top; y <= at.bottom; ++y)
    for (std::size_t x = at.left; x <= at.right; ++x) cells_[y * side_ + x].push_back(thing);
}

std::vector<std::size_t> ScreenGrid::near(const Box2& box) const {
  std::vector<std::size_t> found;
  const Cells at = cells_of(box);
  for (std::size_t y = at.top; y <= at.bottom; ++y)
    for (std::size_t x = at.left; x <= at.right; ++x)
      for (const std::size_t thing : cells_[y * side_ + x])
        if (boxes_[thing].meets(box)) found.push_back(thing);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace foothold::drawing
