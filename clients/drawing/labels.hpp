// Short labels beside points, so that they cover each other and the points as little as may be.
#pragma once

#include <string>
#include <vector>

#include "camera.hpp"

namespace foothold::drawing {

struct Label {
  std::string text;
  Vector3d point;                  // px, what it names
  Vector2d at = Vector2d::Zero();  // px, the label's centre; set by place_labels()
};

// How large labels are: small when there are many.
struct LabelSize {
  double font;    // px
  double height;  // px
};
LabelSize label_size(std::size_t count);
double label_width(const Label& label, LabelSize size);

// Chooses `at` of each label in turn among places round its point, inside `area`. Same input, same places.
void place_labels(std::vector<Label>& labels, LabelSize size, const Rectangle& area);

}  // namespace foothold::drawing
