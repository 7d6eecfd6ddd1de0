// Which things lie near a place on the screen: bounding boxes in square cells.
#pragma once

#include <cstddef>
#include <vector>

#include "polygon.hpp"

namespace foothold::drawing {

class ScreenGrid {
 public:
  // For things inside `bounds`, of which about `expected` will come; what lies outside is kept in the border cells.
  ScreenGrid(const Box2& bounds, std::size_t expected);
  void insert(std::size_t thing, const Box2& box);
  // The things whose box meets this one, each once, by rising number.
  std::vector<std::size_t> near(const Box2& box) const;

 private:
  struct Cells {
    std::size_t left, top, right, bottom;
  };
  Cells cells_of(const Box2& box) const;

  Vector2d low_;
  Vector2d cell_;
  std::size_t side_;
  std::vector<std::vector<std::size_t>> cells_;
  std::vector<Box2> boxes_;  // by thing
};

}  // namespace foothold::drawing
