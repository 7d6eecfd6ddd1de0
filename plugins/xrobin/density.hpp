// Density grids: how many words of n cycles end in each cell, for n = 1 to the cycles that remain after the first.
//
// Built recursively from the arm's free end (Ebert-Uphoff and Chirikjian 1995, the paper's [6]): the points of n cycles are those
// of n - 1 cycles moved by each of the 64 first cycles. A cell's points are taken to lie in its centre, so memory and time do not
// grow with the number of words (64^6 = 7e10) but with the number of cells.
#pragma once

#include <cstdint>
#include <vector>

#include "modules.hpp"

namespace foothold::xrobin {

// Square cells over a square centred on the origin of the frame before them. Immutable; any thread.
class DensityGrid {
 public:
  DensityGrid(int cells, double half_width) : cells_(cells), half_width_(half_width), per_metre_(cells / (2.0 * half_width)) {}

  int cells() const { return cells_; }               // along one side
  double half_width() const { return half_width_; }  // m
  double centre(int k) const { return (k + 0.5) / per_metre_ - half_width_; }
  // The cell that holds the point, or -1 beside the grid.
  std::ptrdiff_t cell(double x, double y) const {
    const double column = (x + half_width_) * per_metre_;
    const double row = (y + half_width_) * per_metre_;
    if (!(column >= 0.0 && row >= 0.0 && column < cells_ && row < cells_)) return -1;
    return static_cast<std::ptrdiff_t>(row) * cells_ + static_cast<std::ptrdiff_t>(column);
  }
  // Words that end in a cell; whole numbers, exact up to 2^53.
  double words(std::size_t cell) const { return words_[cell]; }
  // The place of the cell's density among all densities of the grid: 0 for an empty cell, equal for equal densities. Smaller than
  // the density itself, so that the grids of all cycles stay in the cache.
  std::uint16_t rank(std::size_t cell) const { return ranks_[cell]; }

 private:
  friend std::vector<DensityGrid> density_grids(const std::vector<Module>&, int, int, double);
  void make_ranks();

  int cells_;
  double half_width_;
  double per_metre_;
  std::vector<double> words_;
  std::vector<std::uint16_t> ranks_;
};

inline constexpr int kMostCells = 1001;  // along one side

// Grids of 1 to `most_cycles` cycles, grid n - 1 for n cycles, all over the same square; what ends beside it is not counted.
std::vector<DensityGrid> density_grids(const std::vector<Module>& modules, int most_cycles, int cells, double half_width);

}  // namespace foothold::xrobin
