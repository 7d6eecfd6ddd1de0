// Bit maps that say whether any point lies near a place, and the scan of many places over one: the hot loop of the search of pairs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foothold::xrobin {

// One bit for each cell: whether a point lies within `radius` of the cell.
struct NearMap {
  float radius = 0.0F;  // m
  float per_metre = 0.0F;
  float offset = 0.0F;  // of the grid's corner from the origin, in cells
  std::int32_t columns = 0;
  std::vector<std::uint32_t> bits;

  bool at(float x, float y) const {
    const auto column = static_cast<std::int32_t>(x * per_metre + offset);
    const auto row = static_cast<std::int32_t>(y * per_metre + offset);
    if (static_cast<std::uint32_t>(column) >= static_cast<std::uint32_t>(columns)) return false;
    if (static_cast<std::uint32_t>(row) >= static_cast<std::uint32_t>(columns)) return false;
    const std::int32_t bit = row * columns + column;
    return (bits[static_cast<std::uint32_t>(bit) / 32] >> (bit % 32) & 1u) != 0;
  }
};

// Marks what lies within `radius` + `hair` of the points, all of them within `reach` of the origin; cells are twice `radius` wide.
NearMap near_map(std::span<const float> x, std::span<const float> y, double reach, double radius, double hair);

// Writes the indices of those places (x[k] + dx, y[k] + dy) that are near a point, in rising order, and returns how many. `out` has
// room for all. Eight at a time where the processor can (AVX2), with the same result everywhere.
std::size_t near_places(const NearMap& map, const float* x, const float* y, std::size_t count, float dx, float dy,
                        std::uint32_t* out);

}  // namespace foothold::xrobin
