// Where a leg may put its hip axis, seen along the hip plate's normal: bounds from a table.
//
// A leg that leans by psi puts its hip axis to the height c over its sole and the shift s beside it,
//   s = a sin psi + lambda sin phi2,  c = a cos psi + lambda cos phi2 + a2,  phi1 + phi2 = psi ,
// with both mechanisms within their limits. The table holds the interval of s for each cell of psi and c, rounded outwards: for
// boxes of psi and phi2 the least and the greatest lambda are known from the mechanism's least and greatest offsets. Coarser tables
// hold the intervals of the cells that they join, so that a search begins with few cells and looks closer only where need be.
// Paper's frames. Immutable; any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "hyrecro/model/model.hpp"

namespace foothold::hyrecro {

class LegShifts {
 public:
  explicit LegShifts(const Model& model);

  struct Interval {  // m; empty: low > high
    float low = std::numeric_limits<float>::infinity(), high = -std::numeric_limits<float>::infinity();
    bool empty() const { return low > high; }
    void join(const Interval& other) {
      low = std::min(low, other.low);
      high = std::max(high, other.high);
    }
  };
  static constexpr int kLevels = 6;  // 0 is the finest; each next one joins two cells by two
  int leans(int level) const { return kLeans >> level; }
  int heights(int level) const { return kHeights >> level; }
  double lean_step(int level) const { return lean_step_ * (1 << level); }      // rad
  double height_step(int level) const { return height_step_ * (1 << level); }  // m
  double most_lean() const { return most_lean_; }                              // rad: cells of psi begin at minus that
  // The finest cell of a lean, or -1 if no leg leans so much.
  int lean(double psi) const {
    if (!(std::fabs(psi) <= most_lean_)) return -1;
    return std::min(kLeans - 1, static_cast<int>((psi + most_lean_) / lean_step_));
  }
  // Of the leans and heights of a cell. Empty for heights and leans out of range.
  Interval at(int level, int lean, int height) const {
    return inside(lean, leans(level)) && inside(height, heights(level)) ? square_[index(level)][cell(level, lean, height)]
                                                                        : Interval{};
  }
  // Of one finest cell of leans and the heights of a coarser one.
  Interval of_lean(int level, int lean, int height) const {
    return inside(height, heights(level)) ? column_[index(level)][cell(level, lean, height)] : Interval{};
  }

 private:
  static constexpr int kLeans = 192, kHeights = 128;
  static std::size_t index(int level) { return static_cast<std::size_t>(level); }
  static bool inside(int i, int count) { return i >= 0 && i < count; }
  std::size_t cell(int level, int lean, int height) const { return static_cast<std::size_t>(lean * heights(level) + height); }
  void fill(const Model& model);

  double most_lean_ = 0.0, lean_step_ = 0.0, height_step_ = 0.0;
  std::vector<std::vector<Interval>> square_, column_;  // by level
};

}  // namespace foothold::hyrecro
